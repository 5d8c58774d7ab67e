#pragma once

#include "structure/padding.h"
#include "support/soup.h"

#include <algorithm>
#include <array>
#include <string>

// Families of rays that find the faults of structures; random rays are nearly blind for them. Each
// function takes the corners of at least one triangle, three a triangle. Origins lie in the box of
// the corners and half of its largest side around it, so within usual_reach, unless said otherwise.
namespace raysteps {

inline float largest_side(const Box& box) {
    const glm::vec3 side = box.upper - box.lower;
    return std::max({side.x, side.y, side.z});
}

// A point of the box, or of the box grown by that much on every side.
inline glm::vec3 point_in_box(RandomNumbers& numbers, const Box& box, float grown_by = 0.0f) {
    const glm::vec3 share = 0.5f * numbers.in_cube() + 0.5f;
    return (box.lower - grown_by) + share * ((box.upper - box.lower) + 2.0f * grown_by);
}

inline glm::vec3 point_around(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    const Box box = bounds_of(corners);
    return point_in_box(numbers, box, 0.5f * largest_side(box));
}

inline std::size_t any_corner(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    return static_cast<std::size_t>(numbers.below(static_cast<int>(corners.size())));
}

inline glm::vec3 point_on_edge(RandomNumbers& numbers, std::span<const glm::vec3> corners) {
    const std::size_t a = any_corner(numbers, corners);
    const std::size_t b = a - a % 3 + (a + 1) % 3;
    return corners[a] + numbers.unit() * (corners[b] - corners[a]);
}

// From around the triangles to the middle of them.
inline std::vector<Ray> rays_at_triangles(RandomNumbers& numbers,
                                          std::span<const glm::vec3> corners, int count) {
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

inline std::vector<Ray> rays_at_edges(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                      int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, point_on_edge(numbers, corners) - origin, 0.0f, no_end});
    }
    return rays;
}

inline std::vector<Ray> rays_at_corners(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                        int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, corners[any_corner(numbers, corners)] - origin, 0.0f, no_end});
    }
    return rays;
}

// From a corner to a corner: along edges, across faces, with origins on the surface.
inline std::vector<Ray> rays_between_corners(RandomNumbers& numbers,
                                             std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = corners[any_corner(numbers, corners)];
        const glm::vec3 target = corners[any_corner(numbers, corners)];
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

inline std::vector<Ray> rays_from_inside(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                         int count) {
    const Box box = bounds_of(corners);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = point_in_box(numbers, box);
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

// Along an axis, up or down, on both sides of t = 0; the other components are zeros of either sign.
// One of the origin's coordinates is a corner's, so that the ray runs in planes of the structure.
inline std::vector<Ray> axis_parallel_rays(RandomNumbers& numbers,
                                           std::span<const glm::vec3> corners, int count) {
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

// One component of the direction is zero, and the origin's coordinate there is that of the target,
// which is a point of an edge.
inline std::vector<Ray> rays_with_a_zero(RandomNumbers& numbers, std::span<const glm::vec3> corners,
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

// Segments: t_min and t_max lie anywhere around the triangles, t_min below zero for half of them.
inline std::vector<Ray> segments(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                 int count) {
    std::vector<Ray> rays = rays_at_triangles(numbers, corners, count);
    for (Ray& ray : rays) {
        ray.t_min = 2.0f * numbers.unit() - 1.0f;
        ray.t_max = ray.t_min + 2.0f * numbers.unit();
    }
    return rays;
}

// Planes at lower + i * step along each axis, i = 0 ... cells.
struct Lattice {
    glm::vec3 lower{0.0f};
    glm::vec3 step{1.0f};
    glm::ivec3 cells{1};
};

inline glm::vec3 any_lattice_point(RandomNumbers& numbers, const Lattice& lattice) {
    glm::vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<float>(numbers.below(lattice.cells[axis] + 1));
        point[axis] = lattice.lower[axis] + lattice.step[axis] * i;
    }
    return point;
}

// From a lattice point to a lattice point, both moved out of the lattice along the ray by its
// length: they run through many lattice points on the way, and along edges of cells.
inline std::vector<Ray> rays_through_lattice_points(RandomNumbers& numbers, const Lattice& lattice,
                                                    int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = any_lattice_point(numbers, lattice);
        const glm::vec3 along = any_lattice_point(numbers, lattice) - from;
        rays.push_back({from - along, along, 0.0f, no_end});
    }
    return rays;
}

// In a plane of the lattice, in any direction.
inline std::vector<Ray> rays_in_lattice_planes(RandomNumbers& numbers, const Lattice& lattice,
                                               int count) {
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

// Every ray from its end back to its start, as the crow flies: from t = 3 to before t = 0.
inline std::vector<Ray> reversed(std::span<const Ray> rays) {
    std::vector<Ray> backwards;
    for (const Ray& ray : rays) {
        backwards.push_back({ray.origin + 3.0f * ray.direction, -ray.direction, 0.0f, no_end});
    }
    return backwards;
}

// What no ray should be. A structure must answer all the same, and may not hang or read outside:
// not a number, infinite, without a direction, with a direction too small to divide by.
inline std::vector<Ray> nonsense_rays() {
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

// So short that t overflows, or so long that it nearly underflows. The shortest go along an axis,
// for what else they have would be denormal (docs/numerics.md, what is not covered).
inline std::vector<Ray> rays_of_extreme_length(RandomNumbers& numbers,
                                               std::span<const glm::vec3> corners, int count) {
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

struct RayFamily {
    std::string name;
    std::vector<Ray> rays;
};

// All families of sensible rays that know nothing of a lattice.
inline std::vector<RayFamily> ray_families(RandomNumbers& numbers,
                                           std::span<const glm::vec3> corners, int count) {
    return {{"at triangles", rays_at_triangles(numbers, corners, count)},
            {"at edges", rays_at_edges(numbers, corners, count)},
            {"at corners", rays_at_corners(numbers, corners, count)},
            {"between corners", rays_between_corners(numbers, corners, count)},
            {"from inside", rays_from_inside(numbers, corners, count)},
            {"axis-parallel", axis_parallel_rays(numbers, corners, count)},
            {"with a zero", rays_with_a_zero(numbers, corners, count)},
            {"of extreme length", rays_of_extreme_length(numbers, corners, count)},
            {"segments", segments(numbers, corners, count)}};
}

} // namespace raysteps
