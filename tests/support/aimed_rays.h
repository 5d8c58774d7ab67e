#pragma once

#include "support/soup.h"

namespace raysteps {

// Rays from inside a closed mesh at its edges: random rays are nearly blind for leaks, these are
// not (hard case T1). The origin lies in the cube of that half side; the direction is not
// normalised.
inline std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, float half_side,
                                        int count) {
    const int triangles = static_cast<int>(mesh.corners.size() / 3);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::size_t>(3 * numbers.below(triangles));
        const auto edge = static_cast<std::size_t>(numbers.below(3));
        const glm::vec3 a = mesh.corners[first + edge];
        const glm::vec3 b = mesh.corners[first + (edge + 1) % 3];
        const glm::vec3 origin = half_side * numbers.in_cube();
        rays.push_back({origin, (a + numbers.unit() * (b - a)) - origin, 0.0f, no_end});
    }
    return rays;
}

// The same at its corners (hard case T2).
inline std::vector<Ray> corner_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, float half_side,
                                          int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const auto corner =
            static_cast<std::size_t>(numbers.below(static_cast<int>(mesh.corners.size())));
        const glm::vec3 origin = half_side * numbers.in_cube();
        rays.push_back({origin, mesh.corners[corner] - origin, 0.0f, no_end});
    }
    return rays;
}

} // namespace raysteps
