#pragma once

#include "geometry/layout.h"

#include <glm/vec3.hpp>

#include <array>

namespace raysteps {

// Whether double arithmetic alone proves that the ray's line passes outside the triangle. If so,
// the exact decision is a miss; if not, the answer is open. Ray and corners must be finite.
bool surely_misses(const Ray& ray, const std::array<glm::vec3, 3>& corners);

} // namespace raysteps
