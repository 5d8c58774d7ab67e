#pragma once

#include "geometry/layout.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace raysteps {

using Integer = boost::multiprecision::cpp_int;

// A rational number that is never reduced; the denominator is positive.
struct Fraction {
    Integer numerator = 0;
    Integer denominator = 1;
};

// The float, which is finite, in units of 2^-149, the smallest one: a whole number.
Integer in_units(float value);

// Whether a < b.
bool is_less(const Fraction& a, const Fraction& b);

// The nearest double. For fractions between 2^-1000 and 2^1000 (or 0).
double nearest_double(const Fraction& fraction);

// Where the line of a ray meets the plane of a triangle. Only of a unique point is `unique` true.
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

} // namespace raysteps
