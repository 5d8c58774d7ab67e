#include "hard_cases/aimed_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>

namespace raysteps {

namespace {

constexpr float grazing_angle = 1e-4f;
constexpr float sizes_away = 1e4f;
constexpr float leaving_units = 0x1p-18f; // 64 * 2^-24: shaders/light/leave_surface.glsl

struct Target {
    RandomNumbers& numbers;
    std::span<const glm::vec3> corners;
    Box box;
    float size; // of the box's largest side

    glm::vec3 in_box() const { return point_in_box(numbers, box); }
    const glm::vec3& any_corner() const { return corners[raysteps::any_corner(numbers, corners)]; }
};

struct Corners {
    glm::vec3 a;
    glm::vec3 b;
    glm::vec3 c;
};

Corners any_triangle(const Target& target) {
    const std::size_t first = any_corner(target.numbers, target.corners) / 3 * 3;
    return {target.corners[first], target.corners[first + 1], target.corners[first + 2]};
}

glm::vec3 point_of(RandomNumbers& numbers, const Corners& triangle) {
    float u = numbers.unit();
    float v = numbers.unit();
    if (u + v > 1.0f) {
        u = 1.0f - u;
        v = 1.0f - v;
    }
    return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
}

glm::vec3 normal_of(const Corners& triangle) {
    const glm::vec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const float length = glm::length(normal);
    return length > 0.0f ? normal / length : glm::vec3(0.0f, 0.0f, 1.0f);
}

Ray towards(const glm::vec3& origin, const glm::vec3& point) {
    return {origin, point - origin, 0.0f, no_end};
}

Ray random_ray(const Target& target) {
    return {target.in_box(), target.numbers.in_cube(), 0.0f, no_end};
}

Ray inside_ray(const Target& target) {
    const glm::vec3 point = point_of(target.numbers, any_triangle(target));
    return towards(target.in_box(), point);
}

Ray edge_ray(const Target& target) {
    const Corners triangle = any_triangle(target);
    const glm::vec3 origin = target.in_box();
    return towards(origin, triangle.a + target.numbers.unit() * (triangle.b - triangle.a));
}

Ray vertex_ray(const Target& target) {
    const glm::vec3 corner = target.any_corner();
    return towards(target.in_box(), corner);
}

Ray axis_ray(const Target& target) {
    const int axis = target.numbers.below(3);
    const int other = (axis + 1 + target.numbers.below(2)) % 3;
    glm::vec3 origin = target.in_box();
    origin[other] = target.any_corner()[other];
    glm::vec3 direction(0.0f);
    direction[axis] = target.numbers.below(2) == 0 ? 1.0f : -1.0f;
    return {origin, direction, 0.0f, no_end};
}

Ray grazing_ray(const Target& target) {
    const Corners triangle = any_triangle(target);
    const glm::vec3 normal = normal_of(triangle);
    const glm::vec3 any = target.numbers.in_cube();
    const glm::vec3 along = any - glm::dot(any, normal) * normal;
    const float length = std::max(glm::length(along), 1e-3f);
    const glm::vec3 direction = target.size * (along / length + grazing_angle * normal);
    return {point_of(target.numbers, triangle) - direction, direction, 0.0f, no_end};
}

Ray leaving_ray(const Target& target) {
    const Corners triangle = any_triangle(target);
    const glm::vec3 largest =
        glm::max(glm::abs(triangle.a), glm::max(glm::abs(triangle.b), glm::abs(triangle.c)));
    const float side = target.numbers.below(2) == 0 ? 1.0f : -1.0f;
    const glm::vec3 normal = side * normal_of(triangle);
    const float moved = leaving_units * std::max({largest.x, largest.y, largest.z});
    const glm::vec3 any = target.numbers.in_cube();
    return {point_of(target.numbers, triangle) + moved * normal,
            glm::dot(any, normal) < 0.0f ? -any : any, 0.0f, no_end};
}

Ray far_ray(const Target& target) {
    const glm::vec3 point = point_of(target.numbers, any_triangle(target));
    const glm::vec3 any = target.numbers.in_cube();
    const float length = std::max(glm::length(any), 1e-3f);
    return towards(point + (sizes_away * target.size / length) * any, point);
}

struct FamilyMaker {
    std::string name;
    std::function<Ray(const Target&)> make;
};

} // namespace

std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                 int count) {
    std::vector<Ray> rays;
    rays.reserve(count);
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
    rays.reserve(count);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = mesh.corners[any_corner(numbers, mesh.corners)];
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> random_rays_from_inside(RandomNumbers& numbers, const glm::vec3& half, int count) {
    std::vector<Ray> rays;
    rays.reserve(count);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

std::vector<RayFamily> families_from_inside(std::span<const glm::vec3> corners, std::size_t count,
                                            int seed) {
    const std::vector<FamilyMaker> makers{{"random", random_ray},   {"inside", inside_ray},
                                          {"edge", edge_ray},       {"vertex", vertex_ray},
                                          {"axis", axis_ray},       {"grazing", grazing_ray},
                                          {"leaving", leaving_ray}, {"far", far_ray}};
    const Box box = bounds_of(corners);
    std::vector<RayFamily> families;
    for (const FamilyMaker& maker : makers) {
        RandomNumbers numbers(seed);
        const Target target{numbers, corners, box, largest_side(box)};
        RayFamily family{maker.name, {}};
        for (std::size_t i = 0; i < count; ++i) {
            family.rays.push_back(maker.make(target));
        }
        families.push_back(std::move(family));
    }
    return families;
}

} // namespace raysteps
