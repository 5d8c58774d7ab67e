#include "hard_cases/aimed_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace raysteps {

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
    return numbers.below(corners.size());
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
            ray.direction *= lengths[numbers.below(4)];
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
