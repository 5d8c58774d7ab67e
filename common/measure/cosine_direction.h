#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// A direction over the surface, the more likely the steeper: with the density of the cosine, where
// the points are spread evenly over the directions. The normal has length 1, and the point lies
// anywhere but at zero. The direction need not have length 1.
glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec3& point);

} // namespace raysteps
