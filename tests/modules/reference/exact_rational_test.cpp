#include "reference/exact.h"

#include "catch.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using namespace raysteps;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Rational3 = std::array<Rational, 3>;

Rational3 rational(const glm::vec3& point) {
    return {Rational(point.x), Rational(point.y), Rational(point.z)};
}

Rational3 difference(const Rational3& a, const Rational3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational3 cross(const Rational3& a, const Rational3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const Rational3& a, const Rational3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Another formula and another kind of number: Möller and Trumbore, "Fast, minimum storage
// ray-triangle intersection", 1997, in reduced rationals.
bool is_hit_by_moller_trumbore(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    const Rational3 a = rational(corners[0]);
    const Rational3 edge_b = difference(rational(corners[1]), a);
    const Rational3 edge_c = difference(rational(corners[2]), a);
    const Rational3 direction = rational(ray.direction);
    const Rational3 p = cross(direction, edge_c);
    const Rational determinant = dot(edge_b, p);
    if (determinant == 0) {
        return false;
    }
    const Rational3 from_a = difference(rational(ray.origin), a);
    const Rational3 q = cross(from_a, edge_b);
    const Rational u = dot(from_a, p) / determinant;
    const Rational v = dot(direction, q) / determinant;
    const Rational t = dot(edge_c, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= Rational(ray.t_min) && t <= Rational(ray.t_max);
}

// Floats of very different sizes, and many equal or zero, so that ties are common.
float wild_float(std::mt19937& random) {
    const int digits = std::uniform_int_distribution<int>(-4, 4)(random);
    const int exponent = std::uniform_int_distribution<int>(0, 9)(random);
    if (exponent == 0) {
        return std::ldexp(static_cast<float>(digits), -149);
    }
    if (exponent == 1) {
        return std::ldexp(static_cast<float>(digits), 123);
    }
    if (exponent < 4) {
        return std::uniform_real_distribution<float>(-4.0f, 4.0f)(random);
    }
    return static_cast<float>(digits);
}

glm::vec3 wild_point(std::mt19937& random) {
    const float x = wild_float(random);
    const float y = wild_float(random);
    return {x, y, wild_float(random)};
}

} // namespace

TEST_CASE("integers decide as Moller and Trumbore do in rational numbers", "[reference][exact]") {
    const unsigned seed = 20240817;
    CAPTURE(seed);
    std::mt19937 random(seed);
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 a = wild_point(random);
        const glm::vec3 b = wild_point(random);
        const glm::vec3 c = wild_point(random);
        const glm::vec3 origin = wild_point(random);
        // The middle of bc, a corner, or anything.
        const glm::vec3 target = i % 4 == 0 ? 0.5f * b + 0.5f * c : i % 4 == 1 ? a : c;
        const glm::vec3 direction = i % 4 == 3 ? wild_point(random) : target - origin;
        const Ray ray{origin, direction, 0.0f, std::numeric_limits<float>::max()};
        const bool expected = is_hit_by_moller_trumbore(ray, {a, b, c});
        hits += expected ? 1 : 0;
        CAPTURE(i);
        REQUIRE(exact_intersection(ray, {a, b, c}).hit == expected);
    }
    std::cout << "exact: 4000 wild problems, " << hits << " hits, 0 different\n";
    CHECK(hits > 400); // else the test says little
}
