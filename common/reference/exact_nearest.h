#pragma once

#include "geometry/layout.h"
#include "reference/reference_hit.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace raysteps {

// The nearest triangle that the ray meets as exact_intersection decides; of exactly equal t the
// smallest index wins. Triangle i has the corners 3i, 3i + 1 and 3i + 2.
// A filter in double spares most triangles the exact arithmetic, and changes no answer.
ReferenceHit exact_nearest_hit(const Ray& ray, std::span<const glm::vec3> corners);

// The same without the filter: slow, to check it.
ReferenceHit exact_nearest_hit_unfiltered(const Ray& ray, std::span<const glm::vec3> corners);

// exact_nearest_hit of each ray, on all cores.
std::vector<ReferenceHit> exact_nearest_hits(std::span<const Ray> rays,
                                             std::span<const glm::vec3> corners);

} // namespace raysteps
