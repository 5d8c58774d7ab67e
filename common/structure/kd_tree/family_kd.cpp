#include "basics/timed.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/kd_tree/kd_tree.h"
#include "structure/options.h"
#include "structure/tree_file/tree_file.h"

#include <functional>
#include <string>

namespace raysteps {

namespace {

const std::vector<OptionRow<KdOptions>>& rows() {
    static const std::vector<OptionRow<KdOptions>> all{
        choice_option("split", &KdOptions::split,
                      {{"area", KdSplit::area}, {"median", KdSplit::median}},
                      "area (surface-area heuristic) or median (middle of the longest side)"),
        number_option("traversal-cost", &KdOptions::traversal_cost, 0.0, 1e6,
                      "cost of a step down"),
        number_option("intersection-cost", &KdOptions::intersection_cost, 1e-6, 1e6,
                      "cost of a triangle test"),
        number_option("empty-bonus", &KdOptions::empty_bonus, 0.0, 1.0,
                      "discount, 0 to 1, for a split that cuts off empty space"),
        number_option("leaf-triangles", &KdOptions::leaf_triangles, 0, 1 << 20,
                      "a node with no more triangles is not split"),
        number_option("depth", &KdOptions::depth_limit, -1, 64,
                      "most levels below the root, or -1 for 8 + 1.3 log2 of the triangles"),
        number_option("bad-splits", &KdOptions::bad_splits, 0, 16,
                      "how many splits in a row may not pay by themselves"),
        number_option("memory-limit", &KdOptions::most_bytes, 1, 8192,
                      "most memory for the tree, in MiB", std::size_t{1} << 20)};
    return all;
}

BuiltStructure build(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const KdOptions options = kd_options_of(request);
    const std::string file = asked_tree(request);
    const auto [tree, seconds] = timed([&] {
        return file.empty() ? build_kd_tree(corners, options)
                            : tree_from_file<KdTree>(file, corners, std::identity{});
    });
    BuiltStructure built;
    built.facts = facts_of(tree, options, corners.size() / 3, seconds);
    built.packed = pack(tree);
    return built;
}

} // namespace

KdOptions kd_options_of(const BuildRequest& request) {
    KdOptions options = read_options(rows(), request);
    options.reach = request.reach;
    options.most_texels = request.most_texels;
    return options;
}

std::vector<Fact> facts_of(const KdTree& tree, const KdOptions& options, std::size_t triangles,
                           double seconds) {
    const KdMeasures measures = measure_kd_tree(tree, options);
    const auto references = static_cast<double>(measures.references);
    const auto filled = static_cast<double>(measures.leaves - measures.empty_leaves);
    return {{"build_seconds", seconds},
            {"memory_bytes", static_cast<double>(measures.bytes)},
            {"nodes", static_cast<double>(measures.nodes)},
            {"leaves", static_cast<double>(measures.leaves)},
            {"empty_leaves", static_cast<double>(measures.empty_leaves)},
            {"depth", static_cast<double>(measures.depth)},
            {"references", references},
            {"references_per_triangle",
             triangles == 0 ? 0.0 : references / static_cast<double>(triangles)},
            {"references_per_leaf", filled == 0.0 ? 0.0 : references / filled},
            {"longest_leaf", static_cast<double>(measures.longest_leaf)},
            {"expected_cost", measures.cost}};
}

// Serves every walk kd_NAME.glsl of shaders/structure.
StructureFamily family_kd() {
    std::vector<BuildOption> options = options_of(rows());
    options.push_back(tree_option);
    return {"kd", options, build};
}

} // namespace raysteps
