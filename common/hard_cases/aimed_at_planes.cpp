#include "hard_cases/aimed_rays.h"

#include <glm/vec2.hpp>

#include <array>
#include <cmath>

namespace raysteps {

namespace {

const Box unit_box{glm::vec3(0.0f), glm::vec3(1.0f)};

// Differences of such numbers are floats, so a ray from one such point to another is exact.
glm::vec3 exact_point(RandomNumbers& numbers) {
    const auto coordinate = [&] {
        return static_cast<float>(numbers.below(2048) - 1024) * 0x1p-9f;
    };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
}

} // namespace

Lattice lattice_of(const GridShape& shape) {
    return {shape.lower, shape.cell_size, shape.cells};
}

glm::vec3 any_lattice_point(RandomNumbers& numbers, const Lattice& lattice) {
    glm::vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<float>(numbers.below(lattice.cells[axis] + 1));
        point[axis] = lattice.lower[axis] + lattice.step[axis] * i;
    }
    return point;
}

std::vector<Ray> rays_through_lattice_points(RandomNumbers& numbers, const Lattice& lattice,
                                             int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = any_lattice_point(numbers, lattice);
        const glm::vec3 along = any_lattice_point(numbers, lattice) - from;
        rays.push_back({from - along, along, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_in_lattice_planes(RandomNumbers& numbers, const Lattice& lattice, int count) {
    const glm::vec3 size = lattice.step * glm::vec3(lattice.cells);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        glm::vec3 origin = point_in_box(numbers, {lattice.lower, lattice.lower + size});
        origin[axis] = any_lattice_point(numbers, lattice)[axis];
        glm::vec3 direction = size * numbers.in_cube();
        direction[axis] = 0.0f;
        rays.push_back({origin, direction, -1.0f, no_end});
    }
    return rays;
}

std::vector<RayFamily> lattice_families(RandomNumbers& numbers, const Lattice& lattice, int count) {
    const std::vector<Ray> through = rays_through_lattice_points(numbers, lattice, count);
    return {{"through lattice points", through},
            {"back through lattice points", reversed(through)},
            {"in lattice planes", rays_in_lattice_planes(numbers, lattice, count)}};
}

const Box& any_box(RandomNumbers& numbers, const KdTree& tree) {
    return tree.boxes[numbers.below(tree.boxes.size())];
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
        const std::size_t node = inner[numbers.below(inner.size())];
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

std::vector<AimedBox> rays_in_sides_of_a_box() {
    std::vector<AimedBox> aimed;
    for (int along = 0; along < 3; ++along) {
        for (const int aside : {(along + 1) % 3, (along + 2) % 3}) {
            for (const float place : {0.0f, 1.0f}) {
                for (const float zero : {0.0f, -0.0f}) {
                    for (const float sign : {1.0f, -1.0f}) {
                        Ray ray{glm::vec3(0.5f), glm::vec3(zero), 0.0f, no_end};
                        ray.origin[along] = 0.5f - 1.5f * sign;
                        ray.direction[along] = sign;
                        ray.origin[aside] = place;
                        aimed.push_back({ray, unit_box, true});
                        ray.t_min = -no_end;
                        aimed.push_back({ray, unit_box, true});
                        ray.origin[aside] = place == 0.0f ? -1e-6f : 1.000001f;
                        aimed.push_back({ray, unit_box, false});
                    }
                }
            }
        }
    }
    return aimed;
}

std::vector<AimedBox> rays_at_corners_of_any_box(RandomNumbers& numbers, int count) {
    std::vector<AimedBox> aimed;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 one = exact_point(numbers);
        Box box = bounds_of(std::array{one, exact_point(numbers)});
        const int flat_axis = numbers.below(4);
        if (flat_axis < 3) {
            box.upper[flat_axis] = box.lower[flat_axis];
        }
        glm::vec3 corner;
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
        }
        const glm::vec3 origin = exact_point(numbers);
        aimed.push_back({{origin, corner - origin, 0.0f, no_end}, box, true});
    }
    return aimed;
}

namespace {

// The box begins at x and ends at y, and is wide elsewhere.
AimedBox touched(const glm::vec2& origin, const glm::vec2& direction, float x, float y) {
    return {{glm::vec3(origin, 0.0f), glm::vec3(direction, 0.0f), 0.0f, no_end},
            {{x, -8.0f, -8.0f}, {8.0f, y, 8.0f}},
            true};
}

} // namespace

std::vector<AimedBox> rays_that_touch_a_box(RandomNumbers& numbers, int count) {
    std::vector<AimedBox> aimed{touched({-0x1.000faep-24f, -0x1.9dd1d6p-25f},
                                        {0x1.ffffd2p-1f, 0x1.ffe0a8p-1f}, 0x1.35ba44p+0f,
                                        0x1.35a76ap+0f)};
    while (static_cast<int>(aimed.size()) < count) {
        // Of these, every operation of the test is rounded by as much as can be.
        const glm::vec2 origin = -0x1p-24f * glm::vec2(numbers.in_cube() + 1.0f);
        const glm::vec2 direction = 1.0f - 0.001f * glm::vec2(0.5f * numbers.in_cube() + 0.5f);
        const float x = 1.0f + 0.25f * numbers.unit();
        // In double this is off by far less than a float's step.
        const glm::dvec2 from(origin);
        const glm::dvec2 along(direction);
        const double y = from.y + (static_cast<double>(x) - from.x) / along.x * along.y;
        aimed.push_back(touched(origin, direction, x, std::nextafter(static_cast<float>(y), 2.0f)));
    }
    return aimed;
}

std::vector<AimedBox> rays_far_from_zero() {
    const glm::vec3 offset(1e6f);
    const Box box{offset, offset + 1.0f};
    std::vector<AimedBox> aimed;
    for (int axis = 0; axis < 3; ++axis) {
        // Enters the box at its lower corner, at t = 1 / 0.3.
        Ray ray{offset + glm::vec3(-1.0f), glm::vec3(0.3f), 0.0f, no_end};
        aimed.push_back({ray, box, true});
        ray.t_max = 3.334f;
        aimed.push_back({ray, box, true});
        ray.t_max = 3.333f;
        aimed.push_back({ray, box, false});
        ray.t_max = no_end;
        ray.origin[axis] -= 1.25f;
        aimed.push_back({ray, box, false});
    }
    return aimed;
}

std::vector<AimedBox> rays_that_end_at_a_box() {
    const Ray towards{{0.5f, 0.5f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
    const auto between = [&](float t_min, float t_max) {
        Ray ray = towards;
        ray.t_min = t_min;
        ray.t_max = t_max;
        return ray;
    };
    Ray inside = towards;
    inside.origin.z = 0.5f;
    Ray beyond = towards;
    beyond.origin.z = 1.5f;
    Ray beyond_both_ways = beyond;
    beyond_both_ways.t_min = -1.0f;
    return {{towards, unit_box, true},
            {between(0.0f, 1.0f), unit_box, true},            // the entry
            {between(0.0f, 0x1.fffffep-1f), unit_box, false}, // just before
            {between(2.0f, no_end), unit_box, true},          // the exit
            {between(0x1.000002p+1f, no_end), unit_box, false},
            {inside, unit_box, true},
            {beyond, unit_box, false},
            {beyond_both_ways, unit_box, true}};
}

std::vector<AimedBox> rays_at_the_empty_box(RandomNumbers& numbers, int count) {
    const std::array zero{glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    std::vector<AimedBox> aimed;
    for (const Ray& ray : random_rays(numbers, count)) {
        aimed.push_back({ray, Box{}, false});
    }
    for (const Ray& ray : axis_parallel_rays(numbers, zero, count)) {
        aimed.push_back({ray, Box{}, false});
    }
    return aimed;
}

} // namespace raysteps
