#include "basics/timed.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh4.h"
#include "structure/bvh/family_bvh.h"
#include "structure/tree_file/tree_file.h"

namespace raysteps {

namespace {

// A node of four boxes is seven fetches, and costs less than a test of a triangle for each box: so
// leaves are smaller than in a binary tree.
BvhOptions for_four_boxes() {
    BvhOptions options;
    options.leaf_triangles = 4;
    options.traversal_cost = 1.0;
    return options;
}

// Of two children a node, as collapse makes nodes of four: of its boxes, some are left out.
BuiltStructure read_bvh4(const std::string& file, std::span<const glm::vec3> corners,
                         const BvhOptions& options) {
    const auto [bvh, seconds] = timed([&] {
        return tree_from_file<BoxTree>(
            file, corners, [&](const BoxTree& tree) { return bvh4_of(tree, corners.size() / 3); });
    });
    BuiltStructure built;
    built.packed = pack(bvh, corners);
    built.facts = facts_of(measure_bvh4(bvh, options), corners.size() / 3, built.packed, seconds);
    return built;
}

BuiltStructure build_family_bvh4(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const BvhOptions options = bvh4_options_of(request);
    if (const std::string file = asked_tree(request); !file.empty()) {
        return read_bvh4(file, corners, options);
    }
    const auto [binary, seconds] = timed([&] { return build_bvh(corners, options); });
    const auto [bvh, more_seconds] = timed([&, &binary = binary] { return collapse(binary); });
    BuiltStructure built;
    built.packed = pack(bvh, corners);
    built.facts = facts_of(measure_bvh4(bvh, options), corners.size() / 3, built.packed,
                           seconds + more_seconds);
    built.facts.insert(built.facts.begin() + 1, {"collapse_seconds", more_seconds});
    return built;
}

} // namespace

BvhOptions bvh4_options_of(const BuildRequest& request) {
    return bvh_options_of(request, for_four_boxes());
}

// Serves structure/bvh/bvh4.glsl: the tree of the family `bvh`, with its options, but up to four
// children a node.
StructureFamily family_bvh4() {
    return {"bvh4", bvh_build_options(for_four_boxes()), build_family_bvh4};
}

} // namespace raysteps
