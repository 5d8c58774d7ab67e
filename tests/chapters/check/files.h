#pragma once

#include "basics/random_numbers.h"
#include "hard_cases/meshes.h"
#include "scene/scene.h"
#include "structure/bvh/build_bvh.h"
#include "structure/tree_file/tree_file.h"
#include "support/scene_of.h"

#include <string>
#include <vector>

namespace raysteps {

// A ball of 1,520 triangles.
inline const Scene& ball() {
    static const Scene scene = scene_of(shared_edge_sphere());
    return scene;
}

// A tight tree over it, as other programs build them: boxes end where their triangles do.
inline BoxTree tight_tree(std::span<const glm::vec3> corners) {
    BoxTree tree = box_tree_of(build_bvh(corners, {}));
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        Box& box = tree.nodes[i].box;
        box = {};
        if (is_leaf(tree, i)) {
            const BvhNode& leaf = tree.nodes[i];
            for (std::int32_t r = leaf.first; r < leaf.first + leaf.count; ++r) {
                const auto triangle =
                    static_cast<std::size_t>(tree.order[static_cast<std::size_t>(r)]);
                box = merge(box, bounds_of(corners.subspan(3 * triangle, 3)));
            }
            continue;
        }
        for (const std::int32_t child : children_of(tree, i)) {
            box = merge(box, tree.nodes[static_cast<std::size_t>(child)].box);
        }
    }
    tree.padding = 0.0;
    return tree;
}

// The tree as it comes back from a file.
inline TreeFile written_and_read(const AnyTree& tree) {
    return parse_tree_file(tree_file_bytes({"a test", tree}), "again.rstree");
}

} // namespace raysteps
