#include "reference/brute_force.h"

#include "parallel/on_threads.h"
#include "reference/watertight_test.h"

namespace raysteps {

ReferenceHit nearest_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners) {
    ReferenceHit nearest{.t = ray.t_max};
    const RayAxes axes = axes_of(ray);
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const auto point = meet(ray, axes, corners[first], corners[first + 1], corners[first + 2]);
        if (!point) {
            continue;
        }
        // Of equal t the first, and so the smallest, index stays.
        if (nearest.triangle == no_triangle || point->t < nearest.t) {
            nearest = {point->t, point->u, point->v, static_cast<int>(first / 3)};
        }
    }
    return nearest;
}

ReferenceHit nearest_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_hit(reference_ray(ray), corners);
}

bool any_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners) {
    const RayAxes axes = axes_of(ray);
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        if (meet(ray, axes, corners[first], corners[first + 1], corners[first + 2])) {
            return true;
        }
    }
    return false;
}

bool any_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return any_hit(reference_ray(ray), corners);
}

std::vector<ReferenceHit> nearest_hits(std::span<const Ray> rays,
                                       std::span<const glm::vec3> corners) {
    std::vector<ReferenceHit> hits(rays.size());
    on_threads(all_cores, rays.size(),
               [&](std::size_t i) { hits[i] = nearest_hit(rays[i], corners); });
    return hits;
}

} // namespace raysteps
