#include "structure/bvh/family_bvh.h"

#include "basics/timed.h"
#include "structure/bvh/build_bvh.h"
#include "structure/options.h"
#include "structure/tree_file/tree_file.h"

#include <string>

namespace raysteps {

namespace {

const std::vector<OptionRow<BvhOptions>>& rows() {
    static const std::vector<OptionRow<BvhOptions>> all{
        choice_option("split", &BvhOptions::split,
                      {{"median", BvhSplit::median},
                       {"insertion", BvhSplit::insertion},
                       {"binned", BvhSplit::binned},
                       {"sweep", BvhSplit::sweep}},
                      "median, insertion (one triangle after another), binned or sweep "
                      "(surface-area heuristic at a few planes, or at every one)"),
        number_option("bins", &BvhOptions::bins, 2, 256,
                      "bins per axis for --split binned (planes tried, plus one)"),
        number_option("traversal-cost", &BvhOptions::traversal_cost, 0.0, 1e6,
                      "cost of visiting a node"),
        number_option("intersection-cost", &BvhOptions::intersection_cost, 0.0, 1e6,
                      "cost of a triangle test"),
        number_option("leaf-triangles", &BvhOptions::leaf_triangles, 1, 1 << 20,
                      "most triangles in a leaf"),
        number_option("depth", &BvhOptions::depth_limit, 0, 1 << 20,
                      "most levels below the root, or as many as halving the triangles takes"),
        number_option("memory-limit", &BvhOptions::memory_limit, 1, 1 << 20,
                      "most memory for the tree, in MiB", 1 << 20),
        choice_option(
            "insertion-order", &BvhOptions::insertion_order,
            {{"shuffled", InsertionOrder::shuffled}, {"as_given", InsertionOrder::as_given}},
            "shuffled or as_given, for --split insertion"),
        number_option("seed", &BvhOptions::seed, 0, 1 << 30, "seed of the random insertion order")};
    return all;
}

BuiltStructure build(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const BvhOptions chosen = bvh_options_of(request);
    const std::string file = asked_tree(request);
    const auto [bvh, seconds] = timed([&] {
        return file.empty() ? build_bvh(corners, chosen)
                            : tree_from_file<BoxTree>(file, corners, [&](const BoxTree& tree) {
                                  return bvh_of(tree, corners.size() / 3);
                              });
    });
    BuiltStructure built;
    built.packed = pack(bvh, corners);
    built.facts = facts_of(measure_bvh(bvh, chosen), corners.size() / 3, built.packed, seconds);
    return built;
}

} // namespace

BvhOptions bvh_options_of(const BuildRequest& request, const BvhOptions& defaults) {
    BvhOptions options = read_options(rows(), request, defaults);
    options.reach = static_cast<double>(request.reach);
    return options;
}

std::vector<BuildOption> bvh_build_options(const BvhOptions& defaults) {
    std::vector<BuildOption> options = options_of(rows(), defaults);
    options.push_back(tree_option);
    return options;
}

std::vector<Fact> facts_of(const BvhMeasures& measures, std::size_t triangles,
                           const PackedStructure& packed, double seconds) {
    const auto references = static_cast<double>(measures.references);
    const auto leaves = static_cast<double>(measures.leaves);
    return {{"build_seconds", seconds},
            {"memory_bytes", static_cast<double>(bytes_of(packed))},
            {"tree_bytes", static_cast<double>(measures.bytes)}, // without the walks' copies
            {"nodes", static_cast<double>(measures.nodes)},
            {"leaves", leaves},
            {"depth", static_cast<double>(measures.depth)},
            {"references", references},
            {"references_per_triangle",
             triangles == 0 ? 0.0 : references / static_cast<double>(triangles)},
            {"references_per_leaf", leaves == 0.0 ? 0.0 : references / leaves},
            {"longest_leaf", static_cast<double>(measures.longest_leaf)},
            {"expected_cost", measures.cost}};
}

// Serves every walk bvh_NAME.glsl of shaders/structure.
StructureFamily family_bvh() {
    return {"bvh", bvh_build_options({}), build};
}

} // namespace raysteps
