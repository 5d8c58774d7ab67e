#include "structure/kd_tree/build_kd_tree.h"
#include "structure/structure.h"
#include "structure/kd_tree/kd_tree.h"

#include <chrono>
#include <string>

namespace raysteps {

namespace {

const std::vector<BuildOption>& options() {
    static const std::vector<BuildOption> all{
        {"split", "area", "area (surface-area heuristic) or median (middle of the longest side)"},
        {"traversal-cost", "1", "what a step down costs"},
        {"intersection-cost", "1.5", "what a triangle test costs"},
        {"empty-bonus", "0.2", "by this part a split is cheaper that cuts off empty space"},
        {"leaf-triangles", "2", "so many triangles are never split"},
        {"depth", "-1", "levels below the root, or -1 for 8 + 1.3 log2 of the triangles"},
        {"bad-splits", "0", "splits in a row that may not pay by themselves"},
        {"memory-limit", "4096", "the most that the tree may take, in MiB"},
    };
    return all;
}

KdOptions options_of(const BuildRequest& request) {
    const BuildValues values{options(), request};
    KdOptions chosen;
    chosen.split =
        choice_of<KdSplit>(values, "split", {{"area", KdSplit::area}, {"median", KdSplit::median}});
    chosen.traversal_cost = number_of<double>(values, "traversal-cost", 0.0, 1e6);
    chosen.intersection_cost = number_of<double>(values, "intersection-cost", 1e-6, 1e6);
    chosen.empty_bonus = number_of<double>(values, "empty-bonus", 0.0, 1.0);
    chosen.leaf_triangles = number_of<int>(values, "leaf-triangles", 0, 1 << 20);
    chosen.depth_limit = number_of<int>(values, "depth", -1, 64);
    chosen.bad_splits = number_of<int>(values, "bad-splits", 0, 16);
    chosen.most_bytes = number_of<std::size_t>(values, "memory-limit", 1, 8192) << 20;
    chosen.reach = request.reach;
    return chosen;
}

std::vector<Fact> facts_of(const KdMeasures& measures, std::size_t triangles, double seconds) {
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

BuiltStructure build(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const KdOptions chosen = options_of(request);
    const auto start = std::chrono::steady_clock::now();
    const KdTree tree = build_kd_tree(corners, chosen);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    BuiltStructure built;
    built.facts = facts_of(measure_kd_tree(tree, chosen), corners.size() / 3, seconds.count());
    built.packed = pack(tree);
    return built;
}

} // namespace

// Serves structure/kd_tree/kd_restart.glsl, kd_backtrack.glsl, kd_short_stack.glsl and kd_ropes.glsl.
StructureFamily family_kd() {
    return {"kd", options(), build};
}

} // namespace raysteps
