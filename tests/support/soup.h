#pragma once

#include "geometry/layout.h"
#include "scene/mesh.h"
#include "scene/random_numbers.h"

#include <limits>
#include <vector>

namespace raysteps {

inline constexpr float no_end = std::numeric_limits<float>::max();

// Triangles without order in and around the unit cube.
inline Mesh random_triangles(RandomNumbers& numbers, int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = numbers.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            mesh.corners.push_back(center + 0.3f * numbers.in_cube());
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        }
    }
    return mesh;
}

// Rays from everywhere to everywhere: many hits, many misses.
inline std::vector<Ray> random_rays(RandomNumbers& numbers, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = 2.0f * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

} // namespace raysteps
