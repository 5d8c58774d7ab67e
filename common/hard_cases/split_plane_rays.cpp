#include "hard_cases/split_plane_rays.h"

namespace raysteps {

const Box& any_box(RandomNumbers& numbers, const KdTree& tree) {
    return tree.boxes[static_cast<std::size_t>(numbers.below(static_cast<int>(tree.boxes.size())))];
}

glm::vec3 any_box_corner(RandomNumbers& numbers, const KdTree& tree) {
    const Box& box = any_box(numbers, tree);
    glm::vec3 corner;
    for (int axis = 0; axis < 3; ++axis) {
        corner[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
    }
    return corner;
}

std::vector<Ray> rays_at_box_corners(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, any_box_corner(numbers, tree) - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_through_box_corners(RandomNumbers& numbers, const KdTree& tree, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = any_box_corner(numbers, tree);
        rays.push_back({from, any_box_corner(numbers, tree) - from, -1.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_in_box_planes(RandomNumbers& numbers, const KdTree& tree,
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

std::vector<Ray> rays_in_split_planes(RandomNumbers& numbers, const KdTree& tree, int count) {
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

std::vector<Ray> rays_along_box_edges(RandomNumbers& numbers, const KdTree& tree, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        glm::vec3 direction(0.0f);
        direction[axis] = numbers.below(2) == 0 ? 1.0f : -1.0f;
        rays.push_back({any_box_corner(numbers, tree), direction, -no_end, no_end});
    }
    return rays;
}

std::vector<RayFamily> tree_families(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count) {
    return {{"at box corners", rays_at_box_corners(numbers, tree, corners, count)},
            {"through box corners", rays_through_box_corners(numbers, tree, count)},
            {"in box planes", rays_in_box_planes(numbers, tree, corners, count)},
            {"along box edges", rays_along_box_edges(numbers, tree, count)}};
}

} // namespace raysteps
