#pragma once

#include "geometry/layout.h"

#include <span>

namespace raysteps {

// The greatest distance along one axis from the point to a corner: what BuildRequest asks for.
float reach_of(const glm::vec3& point, std::span<const glm::vec3> corners);

// The greatest over the origins of all rays.
float reach_of(std::span<const Ray> rays, std::span<const glm::vec3> corners);

} // namespace raysteps
