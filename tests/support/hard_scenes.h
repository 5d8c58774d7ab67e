#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"
#include "support/ray_families.h"

#include <vector>

// Sizes, places and shapes at which the arithmetic of a structure can go wrong.
namespace raysteps {

inline Scene moved(Scene scene, float scale, const glm::vec3& offset) {
    for (glm::vec3& corner : scene.corners) {
        corner = scale * corner + offset;
    }
    return scene;
}

// All triangles in one plane, at that place of the axis.
inline Scene flattened(Scene scene, int axis, float place) {
    for (glm::vec3& corner : scene.corners) {
        corner[axis] = place;
    }
    return scene;
}

// Triangles without order, a thousand times longer than wide.
inline Mesh slivers(RandomNumbers& numbers, int count) {
    Mesh mesh = random_triangles(numbers, count);
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        mesh.corners[i + 1] = mesh.corners[i] + 2.0f * numbers.in_cube();
        mesh.corners[i + 2] = mesh.corners[i] + 0.001f * numbers.in_cube();
    }
    return mesh;
}

// At edges, from origins so many times as far away as those of rays_at_edges.
inline std::vector<Ray> rays_from_far_away(RandomNumbers& numbers,
                                           std::span<const glm::vec3> corners, float distance,
                                           int count) {
    std::vector<Ray> rays = rays_at_edges(numbers, corners, count);
    for (Ray& ray : rays) {
        const glm::vec3 target = ray.origin + ray.direction;
        ray.origin *= distance;
        ray.direction = target - ray.origin;
    }
    return rays;
}

} // namespace raysteps
