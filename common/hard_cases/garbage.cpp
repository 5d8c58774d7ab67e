#include "hard_cases/hard_cases.h"

#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace raysteps {

namespace {

constexpr int most_triangles = 60;
constexpr int rays_a_scene = 200;

bool one_in(RandomNumbers& numbers, int count) {
    return numbers.below(count) == 0;
}

// Coordinates are zero or at least this part of the scene's size, so that no sheared coordinate is
// so small that the areas of the triangle test lose their exactness (docs/numerics.md, what is not
// covered).
constexpr int binary_digits_between_sizes = 12;

// A coordinate like those before it, in one of the ways in which coordinates are alike.
float coordinate(RandomNumbers& numbers, const std::vector<float>& before, float size) {
    const int kind = numbers.below(8);
    if (kind < 3 && !before.empty()) {
        const float known = before[numbers.below(before.size())];
        const bool has_neighbours = kind == 2 && known != 0.0f;
        return kind == 1        ? -known
               : has_neighbours ? known * (one_in(numbers, 2) ? 1.0f + 0x1p-23f : 1.0f - 0x1p-24f)
                                : known;
    }
    if (kind == 3) {
        return size * static_cast<float>(numbers.below(5) - 2); // on a lattice
    }
    if (kind == 4) {
        return std::ldexp(size, -numbers.below(binary_digits_between_sizes)); // beside larger ones
    }
    const float any = 2.0f * numbers.unit() - 1.0f;
    return std::abs(any) < std::ldexp(1.0f, -binary_digits_between_sizes) ? 0.0f : size * any;
}

// Points whose coordinates are alike.
struct Points {
    float size = 1.0f;
    std::vector<float> coordinates{};
};

glm::vec3 next_point(RandomNumbers& numbers, Points& points) {
    glm::vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = coordinate(numbers, points.coordinates, points.size);
        points.coordinates.push_back(point[axis]);
    }
    return point;
}

std::vector<glm::vec3> awkward_corners(RandomNumbers& numbers, Points& points) {
    std::vector<glm::vec3> corners;
    const int triangles = numbers.below(most_triangles + 1);
    for (int i = 0; i < 3 * triangles; ++i) {
        const bool is_known = !corners.empty() && one_in(numbers, 3);
        corners.push_back(is_known ? corners[any_corner(numbers, corners)]
                                   : next_point(numbers, points));
    }
    if (one_in(numbers, 6)) { // all in one plane
        const int axis = numbers.below(3);
        for (glm::vec3& corner : corners) {
            corner[axis] = points.size;
        }
    }
    return corners;
}

Ray awkward_ray(RandomNumbers& numbers, const std::vector<glm::vec3>& corners, Points& points) {
    const auto place = [&] {
        const int kind = corners.empty() ? 3 : numbers.below(4);
        return kind == 0   ? corners[any_corner(numbers, corners)]
               : kind == 1 ? point_on_edge(numbers, corners)
                           : next_point(numbers, points);
    };
    Ray ray{place(), glm::vec3(0.0f), 0.0f, no_end};
    ray.direction = place() - ray.origin;
    if (one_in(numbers, 4)) {
        ray.direction[numbers.below(3)] = one_in(numbers, 2) ? 0.0f : -0.0f;
    }
    const float longest =
        std::max({std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(ray.direction[axis]) < std::ldexp(longest, -2 * binary_digits_between_sizes)) {
            ray.direction[axis] = 0.0f;
        }
    }
    if (longest < std::ldexp(points.size, -2 * binary_digits_between_sizes)) {
        ray.direction = glm::vec3(0.0f, 0.0f, points.size);
    }
    if (one_in(numbers, 4)) {
        ray.t_min = static_cast<float>(numbers.below(5) - 2) * 0.5f;
        ray.t_max = ray.t_min + static_cast<float>(numbers.below(4)) * 0.5f;
    }
    return ray;
}

FamilyValues any_values(RandomNumbers& numbers) {
    const std::array splits{"median", "insertion", "binned", "sweep"};
    const auto number = [&](int least, int count) {
        return std::to_string(least + numbers.below(count));
    };
    FamilyValues values;
    values["grid"] = {{"resolution", number(0, 24)}};
    values["kd"] = {{"leaf-triangles", number(0, 4)},
                    {"split", one_in(numbers, 3) ? "median" : "area"},
                    {"bad-splits", number(0, 5)}};
    values["bvh"] = {{"leaf-triangles", number(1, 8)},
                     {"split", splits[numbers.below(4)]},
                     {"bins", number(2, 8)}};
    return values;
}

float any_bits(RandomNumbers& numbers) {
    const std::uint32_t high = static_cast<std::uint32_t>(numbers.below(1 << 16)) << 16;
    return std::bit_cast<float>(high | static_cast<std::uint32_t>(numbers.below(1 << 16)));
}

// Now and then a number becomes any other.
void spoil(RandomNumbers& numbers, glm::vec3& point, int one_of) {
    for (int axis = 0; axis < 3; ++axis) {
        if (one_in(numbers, one_of)) {
            point[axis] = any_bits(numbers);
        }
    }
}

} // namespace

HardScene awkward_scene(int seed) {
    RandomNumbers numbers(seed);
    Points points{std::ldexp(1.0f, numbers.below(21))};
    const std::vector<glm::vec3> corners = awkward_corners(numbers, points);
    HardScene made{mesh_of(corners), {}, 0, any_values(numbers)};
    for (int i = 0; i < rays_a_scene; ++i) {
        made.rays.push_back(awkward_ray(numbers, corners, points));
    }
    return made;
}

HardScene garbage_scene(int seed) {
    HardScene made = awkward_scene(seed);
    RandomNumbers numbers(seed + 1);
    const int one_of = one_in(numbers, 2) ? 1 << 10 : 1 + numbers.below(40);
    for (glm::vec3& corner : made.mesh.corners) {
        spoil(numbers, corner, one_of);
    }
    for (Ray& ray : made.rays) {
        spoil(numbers, ray.origin, 6);
        spoil(numbers, ray.direction, 6);
        if (one_in(numbers, 6)) {
            ray.t_min = any_bits(numbers);
            ray.t_max = any_bits(numbers);
        }
    }
    return made;
}

bool is_finite(const Mesh& mesh) {
    return std::all_of(mesh.corners.begin(), mesh.corners.end(), [](const glm::vec3& corner) {
        return std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z);
    });
}

} // namespace raysteps
