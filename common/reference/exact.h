#pragma once

#include "basics/box.h"
#include "basics/ray.h"
#include "reference/integer3.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace raysteps {

// A rational number that is never reduced; the denominator is positive.
struct Fraction {
    Integer numerator = 0;
    Integer denominator = 1;
};

// The fraction with its denominator above zero.
Fraction with_positive_denominator(const Integer& numerator, const Integer& denominator);

// Whether a < b.
bool is_less(const Fraction& a, const Fraction& b);

// The nearest double. For fractions between 2^-1000 and 2^1000 (or 0).
double nearest_double(const Fraction& fraction);

// Where the line of a ray meets the plane of a triangle. `unique` says whether there is exactly one
// such point.
struct ExactSolution {
    bool unique = false;
    Fraction t;
    Fraction u;
    Fraction v;
    Fraction w; // 1 - u - v
};

// Whether origin and direction are finite, and t_min and t_max are numbers.
bool is_usable(const Ray& ray);

// Solves without rounding. Ray and corners must be usable and finite.
ExactSolution solve_exactly(const Ray& ray, const std::array<glm::vec3, 3>& corners);

// Whether the solution lies in the closed triangle and within the ray's t_min and t_max.
bool is_hit(const ExactSolution& solution, const Ray& ray);

// What exact arithmetic says of one ray and one triangle. The numbers are the doubles nearest to
// the exact ones, given for a miss too if the ray's line meets the triangle's plane in one point,
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

bool is_finite(const std::array<glm::vec3, 3>& corners);

// Decides without rounding whether the ray meets the closed triangle: edges, corners, t_min and
// t_max belong to it. By definition these miss: a ray in the triangle's plane, a triangle of zero
// area, a direction of zero, and whatever is not finite (but an infinite t_max or t_min is fine).
ExactIntersection exact_intersection(const Ray& ray, const std::array<glm::vec3, 3>& corners);

// Decides without rounding whether the ray meets the closed box at t_min or later, its sides and
// corners included; t_max is ignored. All numbers are finite, and the box is not empty.
bool exact_meets_box(const Ray& ray, const Box& box);

// Whether double arithmetic alone proves that the ray's line passes outside the triangle. If so,
// the exact decision is a miss; if not, the answer is open. Ray and corners must be finite.
bool surely_misses(const Ray& ray, const std::array<glm::vec3, 3>& corners);

// Where a ray first meets triangles: at origin + t * direction, which is
// (1 - u - v) * a + u * b + v * c. For a miss, t is the ray's t_max and the triangle no_triangle.
struct ReferenceHit {
    double t = 0.0;
    double u = 0.0;
    double v = 0.0;
    int triangle = no_triangle;
};

// The nearest triangle that the ray meets as exact_intersection decides; of exactly equal t the
// smallest index wins. Triangle i has the corners 3i, 3i + 1 and 3i + 2.
// A filter in double spares most triangles the exact arithmetic, and changes no answer.
ReferenceHit exact_nearest_hit(const Ray& ray, std::span<const glm::vec3> corners);

// The same without the filter: slow, to check it.
ReferenceHit exact_nearest_hit_unfiltered(const Ray& ray, std::span<const glm::vec3> corners);

// exact_nearest_hit of each ray, on all cores. Boxes around triangles spare most of them the filter
// too, by the same kind of bound.
std::vector<ReferenceHit> exact_nearest_hits(std::span<const Ray> rays,
                                             std::span<const glm::vec3> corners);

} // namespace raysteps
