#include "reference/exact.h"

#include "catch.h"
#include "unit_triangle.h"

#include <cmath>
#include <limits>

using namespace raysteps;

TEST_CASE("a ray down onto the unit triangle has the t and u and v that the hand computes",
          "[reference][exact]") {
    const ExactIntersection inside = exact_intersection(down_at(0.25f, 0.5f), unit_triangle);
    CHECK(inside.hit);
    CHECK(inside.t == 2.0);
    CHECK(inside.u == 0.25);
    CHECK(inside.v == 0.5);
    CHECK(inside.margin == 0.25);

    const ExactIntersection outside = exact_intersection(down_at(-0.5f, 0.125f), unit_triangle);
    CHECK_FALSE(outside.hit);
    CHECK(outside.t == 2.0);
    CHECK(outside.u == -0.5);
    CHECK(outside.v == 0.125);
    CHECK(outside.margin == 0.5); // from the edge that it is outside of, not from the nearest one
}

TEST_CASE("t is the double nearest to one third", "[reference][exact]") {
    const Ray ray{{0.25f, 0.25f, 1.0f}, {0.0f, 0.0f, -3.0f}, 0.0f, infinity};
    CHECK(exact_intersection(ray, unit_triangle).t == 1.0 / 3.0);
}

TEST_CASE("a fraction just beside the middle of two doubles goes to the nearer one",
          "[reference][exact]") {
    // Over 2^53 doubles are 2 apart. The middle itself goes to the even one.
    const Integer low = Integer(1) << 53;
    const Integer denominator = Integer(1) << 60;
    const Integer middle = (low + 1) * denominator;
    CHECK(nearest_double({middle, denominator}) == 9007199254740992.0);
    CHECK(nearest_double({middle + 1, denominator}) == 9007199254740994.0);
    CHECK(nearest_double({middle - 1, denominator}) == 9007199254740992.0);
    CHECK(nearest_double({-middle - 1, denominator}) == -9007199254740994.0);
}

TEST_CASE("the edges and the corners belong to the triangle", "[reference][exact]") {
    CHECK(exact_intersection(down_at(0.5f, 0.0f), unit_triangle).hit);
    CHECK(exact_intersection(down_at(0.0f, 0.5f), unit_triangle).hit);
    CHECK(exact_intersection(down_at(0.5f, 0.5f), unit_triangle).hit);
    CHECK(exact_intersection(down_at(0.0f, 0.0f), unit_triangle).hit);
    CHECK(exact_intersection(down_at(1.0f, 0.0f), unit_triangle).hit);
    CHECK(exact_intersection(down_at(0.0f, 1.0f), unit_triangle).hit);
}

TEST_CASE("one float beside an edge is a miss", "[reference][exact]") {
    const float smallest = std::numeric_limits<float>::denorm_min();
    CHECK_FALSE(exact_intersection(down_at(0.5f, -smallest), unit_triangle).hit);
    CHECK_FALSE(exact_intersection(down_at(-smallest, 0.5f), unit_triangle).hit);
    CHECK_FALSE(exact_intersection(down_at(0.5f, std::nextafter(0.5f, 1.0f)), unit_triangle).hit);
    CHECK(exact_intersection(down_at(0.5f, std::nextafter(0.5f, 0.0f)), unit_triangle).hit);
}

TEST_CASE("t_min and t_max belong to the ray", "[reference][exact]") {
    Ray ray = down_at(0.25f, 0.25f);
    ray.t_min = 2.0f;
    ray.t_max = 2.0f;
    CHECK(exact_intersection(ray, unit_triangle).hit);
    ray.t_min = std::nextafter(2.0f, 3.0f);
    ray.t_max = infinity;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray.t_min = -infinity;
    ray.t_max = std::nextafter(2.0f, 1.0f);
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray.t_max = infinity;
    CHECK(exact_intersection(ray, unit_triangle).hit);
    ray.t_min = infinity;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
}

TEST_CASE("a ray through the diagonal of a quad hits both of its triangles",
          "[reference][exact][T4]") {
    const Ray ray{{0, 0, 10}, {0.30458447f, 0.30458447f, -0.9024725f}, 0.0f, infinity};
    const glm::vec3 a(-5, -5, 0);
    const glm::vec3 c(5, 5, 0);
    CHECK(exact_intersection(ray, {a, {5, -5, 0}, c}).hit);
    CHECK(exact_intersection(ray, {a, c, {-5, 5, 0}}).hit);
}
