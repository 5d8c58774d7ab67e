#pragma once

#include "structure/kd_tree.h"
#include "support/ray_families.h"

#include <vector>

// Rays that are aimed at the planes of a tree itself, where a walk can go wrong.
namespace raysteps {

inline const Box& any_box(RandomNumbers& numbers, const KdTree& tree) {
    return tree.boxes[static_cast<std::size_t>(numbers.below(static_cast<int>(tree.boxes.size())))];
}

inline glm::vec3 any_box_corner(RandomNumbers& numbers, const KdTree& tree) {
    const Box& box = any_box(numbers, tree);
    glm::vec3 corner;
    for (int axis = 0; axis < 3; ++axis) {
        corner[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
    }
    return corner;
}

// At corners of boxes, where up to eight leaves meet.
inline std::vector<Ray> rays_at_box_corners(RandomNumbers& numbers, const KdTree& tree,
                                            std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, any_box_corner(numbers, tree) - origin, 0.0f, no_end});
    }
    return rays;
}

// From corner to corner of boxes, from before the first to behind the second.
inline std::vector<Ray> rays_through_box_corners(RandomNumbers& numbers, const KdTree& tree,
                                                 int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = any_box_corner(numbers, tree);
        rays.push_back({from, any_box_corner(numbers, tree) - from, -1.0f, no_end});
    }
    return rays;
}

// In a plane of the tree: one component of the direction is a zero of either sign.
inline std::vector<Ray> rays_in_box_planes(RandomNumbers& numbers, const KdTree& tree,
                                           std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        glm::vec3 origin = point_around(numbers, corners);
        origin[axis] = any_box_corner(numbers, tree)[axis];
        glm::vec3 direction = point_around(numbers, corners) - origin;
        direction[axis] = numbers.below(2) == 0 ? 0.0f : -0.0f;
        rays.push_back({origin, direction, -no_end, no_end});
    }
    return rays;
}

// Along an edge of a box: in two planes at once.
inline std::vector<Ray> rays_along_box_edges(RandomNumbers& numbers, const KdTree& tree,
                                             int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        glm::vec3 direction(0.0f);
        direction[axis] = numbers.below(2) == 0 ? 1.0f : -1.0f;
        rays.push_back({any_box_corner(numbers, tree), direction, -no_end, no_end});
    }
    return rays;
}

// The sphere, far from the origin of its rays: t lies above `distance` at every plane.
inline std::vector<Ray> with_large_t(std::vector<Ray> rays, float distance) {
    for (Ray& ray : rays) {
        ray.direction /= distance;
    }
    return rays;
}

inline std::vector<RayFamily> tree_families(RandomNumbers& numbers, const KdTree& tree,
                                            std::span<const glm::vec3> corners, int count) {
    return {{"at box corners", rays_at_box_corners(numbers, tree, corners, count)},
            {"through box corners", rays_through_box_corners(numbers, tree, count)},
            {"in box planes", rays_in_box_planes(numbers, tree, corners, count)},
            {"along box edges", rays_along_box_edges(numbers, tree, count)}};
}

} // namespace raysteps
