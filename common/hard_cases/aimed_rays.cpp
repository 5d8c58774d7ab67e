#include "hard_cases/aimed_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace raysteps {

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

std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                 int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = point_on_edge(numbers, mesh.corners);
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> corner_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                   int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = mesh.corners[any_corner(numbers, mesh.corners)];
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> random_rays_from_inside(RandomNumbers& numbers, const glm::vec3& half, int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

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

float largest_side(const Box& box) {
    const glm::vec3 side = box.upper - box.lower;
    return std::max({side.x, side.y, side.z});
}

glm::vec3 point_in_box(RandomNumbers& numbers, const Box& box, float grown_by) {
    const glm::vec3 share = 0.5f * numbers.in_cube() + 0.5f;
    return (box.lower - grown_by) + share * ((box.upper - box.lower) + 2.0f * grown_by);
}

glm::vec3 point_around(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    const Box box = bounds_of(corners);
    return point_in_box(numbers, box, 0.5f * largest_side(box));
}

std::size_t any_corner(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    return static_cast<std::size_t>(numbers.below(static_cast<int>(corners.size())));
}

glm::vec3 point_on_edge(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    const std::size_t a = any_corner(numbers, corners);
    const std::size_t b = a - a % 3 + (a + 1) % 3;
    return corners[a] + numbers.unit() * (corners[b] - corners[a]);
}

std::vector<Ray> random_rays(RandomNumbers& numbers, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = 2.0f * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_at_triangles(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                   int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const std::size_t a = any_corner(numbers, corners);
        const glm::vec3 b = corners[a - a % 3 + (a + 1) % 3];
        const glm::vec3 c = corners[a - a % 3 + (a + 2) % 3];
        const glm::vec3 inside = 0.5f * (corners[a] + b + numbers.unit() * (c - b));
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, inside - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_at_edges(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                               int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, point_on_edge(numbers, corners) - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_at_corners(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                 int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, corners[any_corner(numbers, corners)] - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_at_corners_of_boxes(RandomNumbers& numbers,
                                          std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const std::size_t any = any_corner(numbers, corners);
        const Box box = bounds_of(corners.subspan(any - any % 3, 3));
        glm::vec3 target;
        for (int axis = 0; axis < 3; ++axis) {
            target[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
        }
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> grazing_rays(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                              float angle, int count) {
    const auto away = static_cast<double>(largest_side(bounds_of(corners)));
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count) {
        const std::size_t any = any_corner(numbers, corners);
        const glm::dvec3 a(corners[any]);
        const glm::dvec3 b(corners[any - any % 3 + (any + 1) % 3]);
        const glm::dvec3 c(corners[any - any % 3 + (any + 2) % 3]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        // Towards a point of the opposite edge, or away from it.
        const glm::dvec3 along = b + static_cast<double>(numbers.unit()) * (c - b) - a;
        const double side = numbers.below(2) == 0 ? angle : -static_cast<double>(angle);
        if (glm::length(normal) == 0.0 || glm::length(along) == 0.0) {
            rays.push_back({point_around(numbers, corners), glm::vec3(a - b), 0.0f, no_end});
            continue; // a triangle without a plane: any ray at it will do
        }
        const glm::dvec3 direction = away * (glm::normalize(along) + side * glm::normalize(normal));
        const glm::vec3 target(a + 0.5 * along);
        const glm::vec3 origin = target - glm::vec3(direction);
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_between_corners(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                      int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = corners[any_corner(numbers, corners)];
        const glm::vec3 target = corners[any_corner(numbers, corners)];
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_from_inside(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                  int count) {
    const Box box = bounds_of(corners);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_in_box(numbers, box);
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> axis_parallel_rays(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        const int other = (axis + 1 + numbers.below(2)) % 3;
        glm::vec3 origin = point_around(numbers, corners);
        origin[other] = corners[any_corner(numbers, corners)][other];
        glm::vec3 direction(numbers.below(2) == 0 ? 0.0f : -0.0f);
        direction[axis] = numbers.below(2) == 0 ? 1.0f : -1.0f;
        rays.push_back({origin, direction, numbers.below(2) == 0 ? 0.0f : -no_end, no_end});
    }
    return rays;
}

std::vector<Ray> rays_with_a_zero(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                  int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        const glm::vec3 target = point_on_edge(numbers, corners);
        glm::vec3 origin = point_around(numbers, corners);
        origin[axis] = target[axis];
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> segments(RandomNumbers& numbers, std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays = rays_at_triangles(numbers, corners, count);
    for (Ray& ray : rays) {
        ray.t_min = 2.0f * numbers.unit() - 1.0f;
        ray.t_max = ray.t_min + 2.0f * numbers.unit();
    }
    return rays;
}

std::vector<Ray> rays_from_far_away(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    float distance, int count) {
    std::vector<Ray> rays = rays_at_edges(numbers, corners, count);
    for (Ray& ray : rays) {
        const glm::vec3 target = ray.origin + ray.direction;
        ray.origin *= distance;
        ray.direction = target - ray.origin;
    }
    return rays;
}

std::vector<Ray> with_large_t(std::vector<Ray> rays, float factor) {
    for (Ray& ray : rays) {
        ray.direction /= factor;
    }
    return rays;
}

std::vector<Ray> reversed(std::span<const Ray> rays) {
    std::vector<Ray> backwards;
    for (const Ray& ray : rays) {
        backwards.push_back({ray.origin + 3.0f * ray.direction, -ray.direction, 0.0f, no_end});
    }
    return backwards;
}

std::vector<Ray> nonsense_rays() {
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const float smallest = std::numeric_limits<float>::denorm_min();
    const std::array values{0.0f, -0.0f, 1.0f, smallest, no_end, infinite, not_a_number};
    std::vector<Ray> rays;
    for (const float a : values) {
        for (const float b : values) {
            for (int axis = 0; axis < 3; ++axis) {
                Ray ray{{0.1f, 0.2f, 0.3f}, {0.0f, 0.0f, 1.0f}, -no_end, no_end};
                ray.origin[axis] = a;
                ray.direction[axis] = b;
                rays.push_back(ray);
                ray.direction = glm::vec3(b);
                rays.push_back(ray);
                ray.t_min = a;
                ray.t_max = b;
                rays.push_back(ray);
            }
        }
    }
    return rays;
}

std::vector<Ray> rays_of_extreme_length(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                        int count) {
    const std::array lengths{1e-30f, 1e-20f, 1e20f, 1e30f};
    std::vector<Ray> rays = rays_at_triangles(numbers, corners, count);
    for (Ray& ray : rays) {
        ray.t_max = numbers.below(2) == 0 ? no_end : std::numeric_limits<float>::infinity();
        if (numbers.below(2) == 0) {
            ray.direction *= lengths[static_cast<std::size_t>(numbers.below(4))];
        } else {
            const int axis = numbers.below(3);
            const float along = ray.direction[axis] < 0.0f ? -2e-38f : 2e-38f;
            ray.direction = glm::vec3(0.0f);
            ray.direction[axis] = along;
        }
    }
    return rays;
}

std::vector<RayFamily> ray_families(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    int count) {
    return {{"at triangles", rays_at_triangles(numbers, corners, count)},
            {"at edges", rays_at_edges(numbers, corners, count)},
            {"at corners", rays_at_corners(numbers, corners, count)},
            {"at corners of boxes", rays_at_corners_of_boxes(numbers, corners, count)},
            {"grazing", grazing_rays(numbers, corners, 1e-3f, count)},
            {"between corners", rays_between_corners(numbers, corners, count)},
            {"from inside", rays_from_inside(numbers, corners, count)},
            {"axis-parallel", axis_parallel_rays(numbers, corners, count)},
            {"with a zero", rays_with_a_zero(numbers, corners, count)},
            {"of extreme length", rays_of_extreme_length(numbers, corners, count)},
            {"segments", segments(numbers, corners, count)}};
}

} // namespace raysteps
