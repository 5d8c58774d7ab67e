#pragma once

#include "geometry/box.h"

#include <glm/vec3.hpp>

#include <array>

namespace raysteps {

// In double precision, so that 24-bit corners and planes are clipped almost without rounding.
struct ExactBox {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

// The box with its sides moved outwards by the padding.
ExactBox grown(const Box& box, double padding);

// The bounds of that part of the triangle that lies in the box, which is closed, grown by the
// padding and rounded outwards; empty where they do not meet. Source: Sutherland and Hodgman,
// "Reentrant Polygon Clipping", 1974; used so by Havran, "Heuristic Ray Shooting Algorithms", 2000.
Box clipped_bounds(const std::array<glm::vec3, 3>& triangle, const ExactBox& box, double padding);

} // namespace raysteps
