#include "structure/bvh/family_bvh.h"

#include "structure/bvh/build_bvh.h"
#include "structure/structure.h"
#include "structure/bvh/bvh.h"

#include <chrono>
#include <string>

namespace raysteps {

namespace {

// A step costs more here than BvhOptions says: a node is two fetches from memory, and rays that go
// side by side wait for each other at it. chapters/06_bvh --measure shows what the costs do.
const std::vector<BuildOption>& options() {
    static const std::vector<BuildOption> all{
        {"split", "binned",
         "median, insertion (one triangle after the other), binned or sweep (surface-area "
         "heuristic at a few planes, or at all)"},
        {"bins", "32", "planes to try along an axis, and one, for --split binned"},
        {"traversal-cost", "3", "what a node costs"},
        {"intersection-cost", "1.5", "what a triangle test costs"},
        {"leaf-triangles", "7", "no leaf has more"},
        {"depth", "64", "levels below the root, or as many as it takes to halve the triangles"},
        {"memory-limit", "4096", "the most that the tree may take, in MiB"},
        {"insertion-order", "shuffled", "shuffled or as_given, for --split insertion"},
        {"seed", "1", "of the shuffle"},
    };
    return all;
}

std::vector<Fact> facts_of(const BvhMeasures& measures, std::size_t packed_bytes,
                           std::size_t triangles, double seconds) {
    const auto references = static_cast<double>(triangles); // each triangle is in one leaf
    const auto leaves = static_cast<double>(measures.leaves);
    return {{"build_seconds", seconds},
            {"memory_bytes", static_cast<double>(packed_bytes)},
            {"tree_bytes", static_cast<double>(measures.bytes)}, // without the walks' copies
            {"nodes", static_cast<double>(measures.nodes)},
            {"leaves", leaves},
            {"depth", static_cast<double>(measures.depth)},
            {"references", references},
            {"references_per_triangle", triangles == 0 ? 0.0 : 1.0},
            {"references_per_leaf", triangles == 0 ? 0.0 : references / leaves},
            {"longest_leaf", static_cast<double>(measures.longest_leaf)},
            {"expected_cost", measures.cost}};
}

BuiltStructure build(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const BvhOptions chosen = bvh_options_of(request);
    const auto start = std::chrono::steady_clock::now();
    const Bvh bvh = build_bvh(corners, chosen);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    BuiltStructure built;
    built.packed = pack(bvh, corners);
    built.facts = facts_of(measure_bvh(bvh, chosen), bytes_of(built.packed), corners.size() / 3,
                           seconds.count());
    return built;
}

} // namespace

BvhOptions bvh_options_of(const BuildRequest& request) {
    const BuildValues values{options(), request};
    BvhOptions chosen;
    chosen.split = choice_of<BvhSplit>(values, "split",
                                       {{"median", BvhSplit::median},
                                        {"insertion", BvhSplit::insertion},
                                        {"binned", BvhSplit::binned},
                                        {"sweep", BvhSplit::sweep}});
    chosen.bins = number_of<int>(values, "bins", 2, 256);
    chosen.traversal_cost = number_of<double>(values, "traversal-cost", 0.0, 1e6);
    chosen.intersection_cost = number_of<double>(values, "intersection-cost", 0.0, 1e6);
    chosen.leaf_triangles = number_of<int>(values, "leaf-triangles", 1, 1 << 20);
    chosen.depth_limit = number_of<int>(values, "depth", 0, 1 << 20);
    chosen.memory_limit = number_of<std::int64_t>(values, "memory-limit", 1, 1 << 20) * (1 << 20);
    chosen.insertion_order = choice_of<InsertionOrder>(
        values, "insertion-order",
        {{"shuffled", InsertionOrder::shuffled}, {"as_given", InsertionOrder::as_given}});
    chosen.seed = number_of<int>(values, "seed", 0, 1 << 30);
    chosen.reach = static_cast<double>(request.reach);
    return chosen;
}

// Serves structure/bvh/bvh_skip.glsl, bvh_skip_padded.glsl, bvh_ordered.glsl, bvh_parent.glsl and
// bvh_stack.glsl.
StructureFamily family_bvh() {
    return {"bvh", options(), build};
}

} // namespace raysteps
