#include "reference/exact.h"

#include "catch.h"
#include "unit_triangle.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

using namespace raysteps;

namespace {

using Triangle = std::array<glm::vec3, 3>;

std::array<std::uint64_t, 4> bits_of(const ExactIntersection& answer) {
    return {std::bit_cast<std::uint64_t>(answer.t), std::bit_cast<std::uint64_t>(answer.u),
            std::bit_cast<std::uint64_t>(answer.v), std::bit_cast<std::uint64_t>(answer.margin)};
}

} // namespace

TEST_CASE("a tiny triangle is hit as a large one is", "[reference][exact][T5]") {
    const float size = GENERATE(1.0f, 1e-6f, 1e-18f, 1e-30f, 1e-38f, 1e-44f);
    CAPTURE(size);
    const Triangle tiny{glm::vec3(0), glm::vec3(size, 0, 0), glm::vec3(0, size, 0)};
    const Ray ray{{size / 3.0f, size / 3.0f, -1.0f}, {0, 0, 1}, 0.0f, infinity};
    CHECK(exact_intersection(ray, tiny).hit);
}

TEST_CASE("the largest floats do not overflow", "[reference][exact]") {
    const float large = std::numeric_limits<float>::max();
    const Triangle huge{glm::vec3(-large, -large, 0), glm::vec3(large, -large, 0),
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
    const Triangle negated{glm::vec3(-0.0f), {1.0f, -0.0f, -0.0f}, {-0.0f, 1.0f, -0.0f}};
    const ExactIntersection answer = exact_intersection(plus, unit_triangle);
    CHECK(answer.hit);
    CHECK(bits_of(answer) == bits_of(exact_intersection(minus, unit_triangle)));
    CHECK(bits_of(answer) == bits_of(exact_intersection(plus, negated)));
    CHECK(bits_of(answer) == bits_of(exact_intersection(minus, negated)));
}

TEST_CASE("what is not finite misses", "[reference][exact]") {
    const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(), +infinity, -infinity);
    const float way = GENERATE(-1.0f, 1.0f);
    const Ray good{{0.25f, 0.25f, -2.0f * way}, {0.0f, 0.0f, way}, 0.0f, infinity};
    REQUIRE(exact_intersection(good, unit_triangle).hit);
    Ray ray = good;
    ray.origin.z = bad;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = good;
    ray.direction.x = bad;
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    CHECK_FALSE(exact_intersection(good, {glm::vec3(bad, 0, 0), {1, 0, 0}, {0, 1, 0}}).hit);
    ray = good;
    ray.t_min = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = good;
    ray.t_max = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
    ray = good;
    ray.direction = glm::vec3(0.0f);
    CHECK_FALSE(exact_intersection(ray, unit_triangle).hit);
}
