#include "reference/exact.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace raysteps {

namespace {

constexpr int unit_exponent = -149;

// Rays may begin or end at infinity.
bool lies_within(const Fraction& t, float t_min, float t_max) {
    const Integer scaled_t = t.numerator << -unit_exponent;
    const bool begun =
        std::isinf(t_min) ? t_min < 0.0f : in_units(t_min) * t.denominator <= scaled_t;
    const bool ended =
        std::isinf(t_max) ? t_max < 0.0f : in_units(t_max) * t.denominator < scaled_t;
    return begun && !ended;
}

} // namespace

Fraction with_positive_denominator(const Integer& numerator, const Integer& denominator) {
    if (denominator < 0) {
        return {-numerator, -denominator};
    }
    return {numerator, denominator};
}

Integer in_units(float value) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent); // value = mantissa * 2^exponent
    const auto digits = static_cast<std::int64_t>(std::ldexp(mantissa, 24));
    const int shift = exponent - 24 - unit_exponent;
    Integer units = digits;
    // A subnormal float has fewer than 24 digits: what is shifted out is zero.
    return shift >= 0 ? Integer(units << shift) : Integer(units / (Integer(1) << -shift));
}

bool is_less(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

double nearest_double(const Fraction& fraction) {
    if (fraction.numerator == 0) {
        return 0.0;
    }
    const bool is_negative = fraction.numerator < 0;
    Integer numerator = fraction.numerator;
    if (is_negative) {
        numerator = -numerator;
    }
    Integer denominator = fraction.denominator;
    // Scale so that the quotient has 62 or 63 bits: more than the 53 of a double.
    const int shift = 62 + static_cast<int>(msb(denominator)) - static_cast<int>(msb(numerator));
    if (shift >= 0) {
        numerator <<= shift;
    } else {
        denominator <<= -shift;
    }
    Integer quotient;
    Integer remainder;
    divide_qr(numerator, denominator, quotient, remainder);
    auto bits = static_cast<std::uint64_t>(quotient);
    if (remainder != 0) {
        bits |= 1u; // keeps a quotient just beside the middle of two doubles off the middle
    }
    const double magnitude = std::ldexp(static_cast<double>(bits), -shift);
    return is_negative ? -magnitude : magnitude;
}

bool is_usable(const Ray& ray) {
    return is_finite(ray.origin) && is_finite(ray.direction) && !std::isnan(ray.t_min) &&
           !std::isnan(ray.t_max);
}

// The volumes that the direction spans with two corners each, seen from the origin, are in the
// ratio of the barycentric weights (Plücker; as in Shoemake, "Plücker coordinate tutorial", 1998).
ExactSolution solve_exactly(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    const Integer3 origin = point_in_units(ray.origin);
    const Integer3 direction = point_in_units(ray.direction);
    const Integer3 a = difference(point_in_units(corners[0]), origin);
    const Integer3 b = difference(point_in_units(corners[1]), origin);
    const Integer3 c = difference(point_in_units(corners[2]), origin);
    const Integer3 normal = cross(difference(b, a), difference(c, a));
    const Integer determinant = dot(normal, direction);
    if (determinant == 0) {
        return {};
    }
    ExactSolution solution;
    solution.unique = true;
    solution.t = with_positive_denominator(dot(normal, a), determinant);
    solution.u = with_positive_denominator(dot(direction, cross(c, a)), determinant);
    solution.v = with_positive_denominator(dot(direction, cross(a, b)), determinant);
    solution.w = with_positive_denominator(dot(direction, cross(b, c)), determinant);
    return solution;
}

bool is_hit(const ExactSolution& solution, const Ray& ray) {
    return solution.unique && solution.u.numerator >= 0 && solution.v.numerator >= 0 &&
           solution.w.numerator >= 0 && lies_within(solution.t, ray.t_min, ray.t_max);
}

bool is_finite(const std::array<glm::vec3, 3>& corners) {
    return is_finite(corners[0]) && is_finite(corners[1]) && is_finite(corners[2]);
}

ExactIntersection exact_intersection(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    if (!is_usable(ray) || !is_finite(corners)) {
        return {};
    }
    const ExactSolution solution = solve_exactly(ray, corners);
    if (!solution.unique) {
        return {};
    }
    const double u = nearest_double(solution.u);
    const double v = nearest_double(solution.v);
    const double w = nearest_double(solution.w);
    return {is_hit(solution, ray), nearest_double(solution.t), u, v, std::abs(std::min({u, v, w}))};
}

namespace {

// The distance along the ray to a plane, times the unit of the distance itself.
Fraction crossing(const Ray& ray, int axis, float plane) {
    Integer numerator = in_units(plane) - in_units(ray.origin[axis]);
    Integer denominator = in_units(ray.direction[axis]);
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    return {numerator, denominator};
}

} // namespace

bool exact_meets_box(const Ray& ray, const Box& box) {
    std::vector<Fraction> entries{{in_units(ray.t_min), in_units(1.0f)}};
    std::vector<Fraction> exits;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0f) {
            if (ray.origin[axis] < box.lower[axis] || ray.origin[axis] > box.upper[axis]) {
                return false;
            }
            continue;
        }
        const bool up = ray.direction[axis] > 0.0f;
        entries.push_back(crossing(ray, axis, up ? box.lower[axis] : box.upper[axis]));
        exits.push_back(crossing(ray, axis, up ? box.upper[axis] : box.lower[axis]));
    }
    for (const Fraction& exit : exits) {
        for (const Fraction& entry : entries) {
            if (is_less(exit, entry)) {
                return false;
            }
        }
    }
    return true;
}

namespace {

// The bound of Shewchuk's orient3d ("Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", 1997, section 4.3): a 3 x 3 determinant of rounded differences is wrong by
// at most (7 + 56 e) e times the same sum with absolute values, where e = 2^-53. Our third row, the
// direction, is not even rounded. Finite floats cannot overflow in it, nor underflow: products of
// three lie between 2^-447 and 2^390. One e more pays for rounding the bound itself.
constexpr double error_factor = 8.0 / 9007199254740992.0; // 8 * 2^-53

// -1, 0 or +1: the sign of direction . (a x b), or 0 where rounding leaves it open.
int sure_sign_of_volume(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b) {
    const double volume = glm::dot(direction, glm::cross(a, b));
    const double magnitude = std::abs(direction.x) * (std::abs(a.y * b.z) + std::abs(a.z * b.y)) +
                             std::abs(direction.y) * (std::abs(a.z * b.x) + std::abs(a.x * b.z)) +
                             std::abs(direction.z) * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
    const double error = error_factor * magnitude;
    return static_cast<int>(volume > error) - static_cast<int>(volume < -error);
}

} // namespace

// Inside, the three volumes have one sign; so two that surely differ prove a miss.
bool surely_misses(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 a = glm::dvec3(corners[0]) - origin;
    const glm::dvec3 b = glm::dvec3(corners[1]) - origin;
    const glm::dvec3 c = glm::dvec3(corners[2]) - origin;
    const int sign_a = sure_sign_of_volume(direction, b, c);
    const int sign_b = sure_sign_of_volume(direction, c, a);
    const int sign_c = sure_sign_of_volume(direction, a, b);
    return sign_a * sign_b < 0 || sign_b * sign_c < 0 || sign_c * sign_a < 0;
}

} // namespace raysteps
