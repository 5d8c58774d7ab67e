#pragma once

#include "basics/ray.h"
#include "reference/exact.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace raysteps {

inline constexpr double unit_roundoff_of_float = 1.0 / 16777216.0;          // 2^-24
inline constexpr double unit_roundoff_of_double = 1.0 / 9007199254740992.0; // 2^-53

inline std::array<glm::vec3, 3> corners_of(int triangle, std::span<const glm::vec3> corners) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {corners[first], corners[first + 1], corners[first + 2]};
}

// How far rounding can move a barycentric coordinate, near the triangle, of a test that first moves
// the origin of space to the ray's and then takes the sides of the three edges (Plücker or Woop).
// Let e be the unit roundoff, v the farthest corner seen from the origin, s the longest edge.
//   A moved corner is wrong by e |v| a coordinate; projecting it along d adds two products and a
//     difference: 6 e |v| |d|.
//   A side is the cross product of two such corners, which near the triangle are at most s |d| from
//     the ray: 2 sqrt(2) 6 e |v| s |d|^2, and 3 e |v| s |d|^2 for its own rounding: 20 in place
//     of 6.
//   It is divided by the determinant times the longest component of d, at least |d| / sqrt(3):
//     35 e |v| s |d| / |determinant|.
//   The sum that it is divided by has three such errors, each weighed by a coordinate of at most 1:
//     140 e |v| s |d| / |determinant|, rounded up to a power of two.
inline double rounding_bound(const Ray& ray, const std::array<glm::vec3, 3>& corners,
                             double unit_roundoff) {
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 a = glm::dvec3(corners[0]) - glm::dvec3(ray.origin);
    const glm::dvec3 b = glm::dvec3(corners[1]) - glm::dvec3(ray.origin);
    const glm::dvec3 c = glm::dvec3(corners[2]) - glm::dvec3(ray.origin);
    const double farthest = std::max({glm::length(a), glm::length(b), glm::length(c)});
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    const double determinant = std::abs(glm::dot(direction, glm::cross(b - a, c - a)));
    return 256.0 * unit_roundoff * farthest * longest * glm::length(direction) / determinant;
}

// How far rounding can move t: three depths of at most the farthest corner's, each weighed with a
// coordinate of that error, over the longest component of the direction; and four roundings of t.
inline double rounding_bound_of_t(const Ray& ray, const std::array<glm::vec3, 3>& corners,
                                  double unit_roundoff, double t) {
    const glm::dvec3 origin(ray.origin);
    double farthest = 0.0;
    for (const glm::vec3& corner : corners) {
        farthest = std::max(farthest, glm::length(glm::dvec3(corner) - origin));
    }
    const double step = farthest * std::sqrt(3.0) / glm::length(glm::dvec3(ray.direction));
    return 3.0 * rounding_bound(ray, corners, unit_roundoff) * step +
           4.0 * unit_roundoff * std::abs(t);
}

// Whether rounding can excuse an answer about this triangle: the exact point lies nearer to an edge
// than the rounding reaches. No triangle needs no excuse, and gives none.
inline bool is_too_close_to_call(const Ray& ray, int triangle, std::span<const glm::vec3> corners,
                                 double unit_roundoff) {
    if (triangle == no_triangle) {
        return false;
    }
    const auto three = corners_of(triangle, corners);
    return exact_intersection(ray, three).margin <= rounding_bound(ray, three, unit_roundoff);
}

} // namespace raysteps
