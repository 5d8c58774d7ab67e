#pragma once

#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"

namespace raysteps {

// What the rays of a test are aimed at. Corners and edges are where tests fail.
enum class Aim { anywhere, at_edges, at_corners };

// Rays from a cube around the origin, at the mesh; they never end.
inline std::vector<Ray> rays_at(const Mesh& mesh, Aim aim, int count, float half_side,
                                RandomNumbers& numbers) {
    const glm::vec3 half(half_side);
    std::vector<Ray> rays = aim == Aim::at_corners ? corner_aimed_rays(numbers, mesh, half, count)
                            : aim == Aim::at_edges ? edge_aimed_rays(numbers, mesh, half, count)
                                                   : random_rays_from_inside(numbers, half, count);
    for (Ray& ray : rays) {
        ray.t_max = std::numeric_limits<float>::infinity();
    }
    return rays;
}

} // namespace raysteps
