#pragma once

#include "basics/ray.h"

#include <glm/vec3.hpp>

#include <limits>
#include <random>
#include <span>
#include <vector>

namespace raysteps {

using Random = std::mt19937;

inline glm::vec3 point_in_cube(Random& random, float half_side) {
    std::uniform_real_distribution<float> coordinate(-half_side, half_side);
    const float x = coordinate(random);
    const float y = coordinate(random);
    return {x, y, coordinate(random)};
}

// From the origin to the target at t = 1, and on without end.
inline Ray ray_through(const glm::vec3& origin, const glm::vec3& target) {
    return {origin, target - origin, 0.0f, std::numeric_limits<float>::infinity()};
}

// Where the rays of a test are aimed at. Corners and edges are where tests fail.
enum class Aim { anywhere, at_edges, at_corners };

// Rays from random points of a cube around the origin, aimed at a random point of the mesh.
inline std::vector<Ray> random_rays(Aim aim, std::size_t count, float half_side,
                                    std::span<const glm::vec3> corners, Random& random) {
    std::uniform_int_distribution<std::size_t> any_triangle(0, corners.size() / 3 - 1);
    std::uniform_real_distribution<float> any_share(0.0f, 1.0f);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const std::size_t first = 3 * any_triangle(random);
        const glm::vec3 origin = point_in_cube(random, half_side);
        const glm::vec3 a = corners[first];
        const glm::vec3 b = corners[first + 1];
        const float share = any_share(random);
        if (aim == Aim::at_corners) {
            rays.push_back(ray_through(origin, a));
        } else if (aim == Aim::at_edges) {
            rays.push_back(ray_through(origin, a + share * (b - a)));
        } else {
            rays.push_back(ray_through(origin, origin + point_in_cube(random, 1.0f)));
        }
    }
    return rays;
}

} // namespace raysteps
