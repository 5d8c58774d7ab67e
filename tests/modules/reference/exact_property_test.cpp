#include "reference/exact.h"

#include "catch.h"
#include "rounding_bound.h"
#include "unit_triangle.h"

#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace raysteps;

namespace {

// Multiples of 1/64 up to 16: sums and small multiples of them are still floats without rounding.
glm::vec3 lattice_point() {
    const auto coordinate = [] {
        return static_cast<float>(*rc::gen::inRange(-1024, 1025)) / 64.0f;
    };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
}

struct Problem {
    Ray ray;
    std::array<glm::vec3, 3> corners;
};

// Half of the rays are aimed at the triangle: at a corner, the middle of an edge, or inside.
Problem any_problem() {
    const std::array<glm::vec3, 3> corners{lattice_point(), lattice_point(), lattice_point()};
    const glm::vec3 origin = lattice_point();
    const int quarters_of_b = *rc::gen::inRange(0, 5);
    const int quarters_of_c = *rc::gen::inRange(0, 5 - quarters_of_b);
    const glm::vec3 target = corners[0] + (corners[1] - corners[0]) * (0.25f * quarters_of_b) +
                             (corners[2] - corners[0]) * (0.25f * quarters_of_c);
    const glm::vec3 direction = *rc::gen::arbitrary<bool>() ? target - origin : lattice_point();
    return {{origin, direction, 0.0f, infinity}, corners};
}

} // namespace

TEST_CASE("moving everything by one vector changes nothing", "[reference][exact]") {
    REQUIRE(rc::check([] {
        const Problem problem = any_problem();
        const glm::vec3 shift = lattice_point();
        Problem moved = problem;
        moved.ray.origin += shift;
        for (glm::vec3& corner : moved.corners) {
            corner += shift;
        }
        const auto before = exact_intersection(problem.ray, problem.corners);
        const auto after = exact_intersection(moved.ray, moved.corners);
        RC_ASSERT(before.hit == after.hit);
        RC_ASSERT(before.t == after.t);
        RC_ASSERT(before.u == after.u);
        RC_ASSERT(before.v == after.v);
        RC_ASSERT(before.margin == after.margin);
    }));
}

TEST_CASE("moving the origin along the ray by a power of two takes it off t",
          "[reference][exact]") {
    REQUIRE(rc::check([] {
        Problem problem = any_problem();
        problem.ray.t_min = -infinity;
        const float step = std::ldexp(1.0f, *rc::gen::inRange(-3, 4));
        Ray moved = problem.ray;
        moved.origin += step * moved.direction;
        const auto before = exact_intersection(problem.ray, problem.corners);
        const auto after = exact_intersection(moved, problem.corners);
        RC_ASSERT(before.hit == after.hit);
        RC_ASSERT(before.u == after.u);
        RC_ASSERT(before.v == after.v);
        // Each t is rounded once, and so is the difference here.
        const double expected = before.hit ? before.t - step : after.t;
        const double bound =
            unit_roundoff_of_double * (std::abs(before.t) + std::abs(after.t) + std::abs(expected));
        RC_ASSERT(std::abs(after.t - expected) <= bound);
    }));
}

TEST_CASE("t and the barycentric coordinates name the same point", "[reference][exact]") {
    REQUIRE(rc::check([] {
        const Problem problem = any_problem();
        const auto answer = exact_intersection(problem.ray, problem.corners);
        RC_PRE(answer.hit);
        const glm::dvec3 a(problem.corners[0]);
        const glm::dvec3 b(problem.corners[1]);
        const glm::dvec3 c(problem.corners[2]);
        const glm::dvec3 on_ray =
            glm::dvec3(problem.ray.origin) + answer.t * glm::dvec3(problem.ray.direction);
        const glm::dvec3 on_triangle =
            (1.0 - answer.u - answer.v) * a + answer.u * b + answer.v * c;
        // On the ray: t, the product and the sum are rounded once, all at most 16 + t |d|, where
        // t |d| is the way from the origin: at most 64. On the triangle: three weights of up to
        // three roundings, three products and two sums, of at most 16. Together under 512 roundings
        // of 1.
        RC_ASSERT(glm::length(on_ray - on_triangle) <= 512.0 * unit_roundoff_of_double);
    }));
}

TEST_CASE("the corners may be listed in any order", "[reference][exact]") {
    REQUIRE(rc::check([] {
        const Problem problem = any_problem();
        const auto& [a, b, c] = problem.corners;
        const auto answer = exact_intersection(problem.ray, problem.corners);
        const auto turned = exact_intersection(problem.ray, {b, c, a});
        const auto mirrored = exact_intersection(problem.ray, {a, c, b});
        RC_ASSERT(turned.hit == answer.hit);
        RC_ASSERT(turned.t == answer.t);
        RC_ASSERT(turned.margin == answer.margin);
        RC_ASSERT(mirrored.hit == answer.hit);
        RC_ASSERT(mirrored.t == answer.t);
        RC_ASSERT(mirrored.u == answer.v);
        RC_ASSERT(mirrored.v == answer.u);
    }));
}

TEST_CASE("a ray through the inside of a quad hits one of its halves and on the diagonal both",
          "[reference][exact]") {
    REQUIRE(rc::check([] {
        const glm::vec3 a = lattice_point();
        const glm::vec3 p = lattice_point();
        const glm::vec3 q = lattice_point();
        const int p_share = *rc::gen::inRange(1, 8);
        const int q_share = *rc::gen::inRange(1, 8);
        const glm::vec3 target = a + p * (0.125f * p_share) + q * (0.125f * q_share);
        const glm::vec3 origin = lattice_point();
        const Ray ray{origin, target - origin, 0.0f, infinity};
        // Not in the quad's plane. Lattice points have 11 bits and the direction 15: double is
        // exact.
        RC_PRE(glm::dot(glm::cross(glm::dvec3(p), glm::dvec3(q)), glm::dvec3(ray.direction)) !=
               0.0);
        const bool first = exact_intersection(ray, {a, a + p, a + p + q}).hit;
        const bool second = exact_intersection(ray, {a, a + p + q, a + q}).hit;
        RC_ASSERT(first == (p_share >= q_share));
        RC_ASSERT(second == (p_share <= q_share));
    }));
}
