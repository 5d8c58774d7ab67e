#pragma once

#include "structure/build_grid.h"
#include "structure/build_kd_tree.h"
#include "support/ray_families.h"

#include <vector>

namespace raysteps {

// In a split plane of a kd-tree, in any direction from within the node that it splits.
inline std::vector<Ray> rays_in_split_planes(RandomNumbers& numbers, const KdTree& tree,
                                             int count) {
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (!is_leaf(tree.nodes[i])) {
            inner.push_back(i);
        }
    }
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count && !inner.empty()) {
        const std::size_t node =
            inner[static_cast<std::size_t>(numbers.below(static_cast<int>(inner.size())))];
        const int axis = tree.nodes[node].axis;
        glm::vec3 origin = point_in_box(numbers, tree.boxes[node]);
        origin[axis] = tree.nodes[node].split;
        glm::vec3 direction = numbers.in_cube();
        direction[axis] = 0.0f;
        rays.push_back({origin, direction, -no_end, no_end});
    }
    return rays;
}

// From around the triangles to corners of the nodes of a kd-tree, where planes meet.
inline std::vector<Ray> rays_at_node_corners(RandomNumbers& numbers, const KdTree& tree,
                                             std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Box& box = tree.boxes[static_cast<std::size_t>(
            numbers.below(static_cast<int>(tree.boxes.size())))];
        glm::vec3 corner;
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
        }
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, corner - origin, 0.0f, no_end});
    }
    return rays;
}

// Rays that know where a grid and a kd-tree over the triangles have their planes.
inline std::vector<RayFamily> plane_families(RandomNumbers& numbers,
                                             std::span<const glm::vec3> corners, int count) {
    const GridShape shape = build_grid(corners, {}).shape;
    const Lattice lattice{shape.lower, shape.cell_size, shape.cells};
    const KdTree tree = build_kd_tree(corners, {});
    const std::vector<Ray> through = rays_through_lattice_points(numbers, lattice, count);
    return {{"through points of the grid", through},
            {"back through points of the grid", reversed(through)},
            {"in planes of the grid", rays_in_lattice_planes(numbers, lattice, count)},
            {"in split planes", rays_in_split_planes(numbers, tree, count)},
            {"at corners of nodes", rays_at_node_corners(numbers, tree, corners, count)}};
}

} // namespace raysteps
