#pragma once

#include "geometry/layout.h"
#include "reference/reference_hit.h"
#include "reference/reference_ray.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace raysteps {

// The nearest triangle, found by asking every triangle in double with a watertight test; of equal t
// the smallest index wins. Triangle i has the corners 3i, 3i + 1 and 3i + 2. Closed as
// exact_intersection is: edges, corners, t_min and t_max belong. A ray that is not finite misses.
ReferenceHit nearest_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners);
ReferenceHit nearest_hit(const Ray& ray, std::span<const glm::vec3> corners);

// Whether the ray meets any triangle.
bool any_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners);
bool any_hit(const Ray& ray, std::span<const glm::vec3> corners);

// nearest_hit of each ray, on all cores.
std::vector<ReferenceHit> nearest_hits(std::span<const Ray> rays,
                                       std::span<const glm::vec3> corners);

} // namespace raysteps
