#pragma once

#include "geometry/layout.h"

#include <glm/vec3.hpp>

#include <array>

namespace raysteps {

// What exact arithmetic says of one ray and one triangle. The numbers are the doubles nearest to
// the exact ones, given also of a miss if the ray's line meets the triangle's plane in one point,
// and else 0: at origin + t * direction, which is (1 - u - v) * a + u * b + v * c. The margin says
// how far the triangle's edges are from flipping the decision: it is |min(u, v, 1 - u - v)|, the
// share of a height of the triangle by which the point lies inside its nearest edge, or outside its
// farthest one. It does not look at t_min and t_max.
struct ExactIntersection {
    bool hit = false;
    double t = 0.0;
    double u = 0.0;
    double v = 0.0;
    double margin = 0.0;
};

// Decides without rounding whether the ray meets the closed triangle: edges, corners, t_min and
// t_max belong to it. By definition these miss: a ray in the triangle's plane, a triangle of zero
// area, a direction of zero, and whatever is not finite (but an infinite t_max or t_min is fine).
ExactIntersection exact_intersection(const Ray& ray, const std::array<glm::vec3, 3>& corners);

} // namespace raysteps
