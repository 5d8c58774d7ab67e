#include "reference/exact_intersection.h"

#include "catch.h"
#include "ray_families.h"

#include <bit>
#include <cmath>
#include <cstdint>

using namespace raysteps;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

using Corners = std::array<glm::vec3, 3>;
const Corners unit_triangle{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};

// Straight down from height 2 onto the plane of the unit triangle.
Ray down_at(float x, float y) {
    return {{x, y, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, infinity};
}

std::array<std::uint64_t, 4> bits_of(const ExactIntersection& answer) {
    return {std::bit_cast<std::uint64_t>(answer.t), std::bit_cast<std::uint64_t>(answer.u),
            std::bit_cast<std::uint64_t>(answer.v), std::bit_cast<std::uint64_t>(answer.margin)};
}

} // namespace

TEST_CASE("a ray down onto the unit triangle has the t and u and v that the hand computes",
          "[reference][exact]") {
    const ExactIntersection inside = exact_intersection(down_at(0.25f, 0.5f), unit_triangle);
    CHECK(inside.hit);
    CHECK(inside.t == 2.0);
    CHECK(inside.u == 0.25);
    CHECK(inside.v == 0.5);
    CHECK(inside.margin == 0.25);

    const ExactIntersection outside = exact_intersection(down_at(-0.5f, 2.0f), unit_triangle);
    CHECK_FALSE(outside.hit);
    CHECK(outside.t == 2.0);
    CHECK(outside.u == -0.5);
    CHECK(outside.v == 2.0);
    CHECK(outside.margin == 0.5);
}

TEST_CASE("t is the double nearest to one third", "[reference][exact]") {
    const Ray ray{{0.25f, 0.25f, 1.0f}, {0.0f, 0.0f, -3.0f}, 0.0f, infinity};
    CHECK(exact_intersection(ray, unit_triangle).t == 1.0 / 3.0);
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

TEST_CASE("a tiny triangle is hit as a large one is", "[reference][exact][T5]") {
    const float size = GENERATE(1.0f, 1e-6f, 1e-18f, 1e-30f, 1e-38f, 1e-44f);
    CAPTURE(size);
    const Corners tiny{glm::vec3(0), glm::vec3(size, 0, 0), glm::vec3(0, size, 0)};
    const Ray ray{{size / 3.0f, size / 3.0f, -1.0f}, {0, 0, 1}, 0.0f, infinity};
    CHECK(exact_intersection(ray, tiny).hit);
}

TEST_CASE("the largest floats do not overflow", "[reference][exact]") {
    const float large = std::numeric_limits<float>::max();
    const Corners huge{glm::vec3(-large, -large, 0), glm::vec3(large, -large, 0),
                       glm::vec3(0, large, 0)};
    const Ray ray{{0, 0, large}, {0, 0, -large}, 0.0f, infinity};
    const ExactIntersection answer = exact_intersection(ray, huge);
    CHECK(answer.hit);
    CHECK(answer.t == 1.0);
    CHECK(answer.u == 0.25);
    CHECK(answer.v == 0.5);
}

TEST_CASE("a triangle of zero area is never hit", "[reference][exact][T8]") {
    const Ray ray{{1, 1, 5}, {0, 0, -1}, 0.0f, infinity};
    CHECK_FALSE(exact_intersection(ray, {glm::vec3(1, 1, 0), {1, 1, 0}, {1, 1, 0}}).hit);
    CHECK_FALSE(exact_intersection(ray, {glm::vec3(1, 1, 0), {1, 1, 0}, {2, 2, 0}}).hit);
    CHECK_FALSE(exact_intersection(ray, {glm::vec3(0, 0, 0), {1, 1, 0}, {3, 3, 0}}).hit);
}

TEST_CASE("a ray in the plane of the triangle misses it", "[reference][exact][T9]") {
    const Ray along{{-1.0f, 0.25f, 0.0f}, {1, 0, 0}, 0.0f, infinity};
    const ExactIntersection answer = exact_intersection(along, unit_triangle);
    CHECK_FALSE(answer.hit);
    CHECK(answer.margin == 0.0);
}

TEST_CASE("minus zero gives the same bits as plus zero", "[reference][exact][T10]") {
    const Ray plus{{0.0f, 0.25f, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, infinity};
    const Ray minus{{-0.0f, 0.25f, 2.0f}, {-0.0f, -0.0f, -1.0f}, -0.0f, infinity};
    const Corners negated{glm::vec3(-0.0f), {1.0f, -0.0f, -0.0f}, {-0.0f, 1.0f, -0.0f}};
    const ExactIntersection answer = exact_intersection(plus, unit_triangle);
    CHECK(answer.hit);
    CHECK(bits_of(answer) == bits_of(exact_intersection(minus, unit_triangle)));
    CHECK(bits_of(answer) == bits_of(exact_intersection(plus, negated)));
    CHECK(bits_of(answer) == bits_of(exact_intersection(minus, negated)));
}

TEST_CASE("what is not finite misses", "[reference][exact]") {
    const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(), +infinity, -infinity);
    Ray ray = down_at(0.25f, 0.25f);
    ray.origin.z = bad;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = down_at(0.25f, 0.25f);
    ray.direction.x = bad;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = down_at(0.25f, 0.25f);
    CHECK_FALSE(exact_intersection(ray, {glm::vec3(0, 0, bad), {1, 0, 0}, {0, 1, 0}}).hit);
    ray.t_min = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = down_at(0.25f, 0.25f);
    ray.t_max = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = down_at(0.25f, 0.25f);
    ray.direction = glm::vec3(0.0f);
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
}
