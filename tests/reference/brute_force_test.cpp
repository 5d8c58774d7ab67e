#include "reference/brute_force.h"

#include "catch.h"
#include "ray_families.h"

#include <glm/common.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

using namespace raysteps;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

using Corners = std::vector<glm::vec3>;
const Corners unit_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

Ray down_at(float x, float y) {
    return {{x, y, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, infinity};
}

std::array<std::uint64_t, 3> bits_of(const ReferenceHit& hit) {
    return {std::bit_cast<std::uint64_t>(hit.t), std::bit_cast<std::uint64_t>(hit.u),
            std::bit_cast<std::uint64_t>(hit.v)};
}

bool is_hit(const Ray& ray, const Corners& corners) {
    const bool nearest = nearest_hit(ray, corners).triangle != no_triangle;
    REQUIRE(any_hit(ray, corners) == nearest); // the two must always agree
    return nearest;
}

} // namespace

TEST_CASE("in double a ray down onto the unit triangle has the t and u and v of the hand",
          "[reference][brute]") {
    const ReferenceHit hit = nearest_hit(down_at(0.25f, 0.5f), unit_triangle);
    CHECK(hit.triangle == 0);
    CHECK(hit.t == 2.0);
    CHECK(hit.u == 0.25);
    CHECK(hit.v == 0.5);
    const ReferenceHit miss = nearest_hit(down_at(-0.5f, 0.5f), unit_triangle);
    CHECK(miss.triangle == no_triangle);
    CHECK(miss.t == double{infinity});
}

TEST_CASE("in double a ray along each axis and from both sides has the same answer",
          "[reference][brute]") {
    const int axis = GENERATE(0, 1, 2);
    const float side = GENERATE(-1.0f, 1.0f);
    const auto turned = [&](float x, float y, float z) {
        glm::vec3 point(0.0f);
        point[(axis + 1) % 3] = x;
        point[(axis + 2) % 3] = y;
        point[axis] = z;
        return point;
    };
    const Corners corners{turned(0, 0, 0), turned(1, 0, 0), turned(0, 1, 0)};
    const Ray ray{turned(0.25f, 0.5f, 2 * side), turned(0, 0, -side), 0.0f, infinity};
    const ReferenceHit hit = nearest_hit(ray, corners);
    CHECK(hit.t == 2.0);
    CHECK(hit.u == 0.25);
    CHECK(hit.v == 0.5);
}

TEST_CASE("in double the edges and the corners belong to the triangle", "[reference][brute]") {
    CHECK(is_hit(down_at(0.5f, 0.0f), unit_triangle));
    CHECK(is_hit(down_at(0.0f, 0.5f), unit_triangle));
    CHECK(is_hit(down_at(0.5f, 0.5f), unit_triangle));
    CHECK(is_hit(down_at(0.0f, 0.0f), unit_triangle));
    CHECK(is_hit(down_at(1.0f, 0.0f), unit_triangle));
    CHECK(is_hit(down_at(0.0f, 1.0f), unit_triangle));
    CHECK_FALSE(is_hit(down_at(0.5f, std::nextafter(0.5f, 1.0f)), unit_triangle));
}

TEST_CASE("in double t_min and t_max belong to the ray", "[reference][brute]") {
    Ray ray = down_at(0.25f, 0.25f);
    ray.t_min = 2.0f;
    ray.t_max = 2.0f;
    CHECK(is_hit(ray, unit_triangle));
    ray.t_min = std::nextafter(2.0f, 3.0f);
    ray.t_max = infinity;
    CHECK_FALSE(is_hit(ray, unit_triangle));
    ray.t_min = 0.0f;
    ray.t_max = std::nextafter(2.0f, 1.0f);
    CHECK_FALSE(is_hit(ray, unit_triangle));
}

TEST_CASE("in double a ray through the diagonal hits the quad", "[reference][brute][T4]") {
    const Ray ray{{0, 0, 10}, {0.30458447f, 0.30458447f, -0.9024725f}, 0.0f, infinity};
    CHECK(is_hit(ray, {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}}));
    CHECK(is_hit(ray, {{-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}));
}

TEST_CASE("in double tiny and huge triangles are hit", "[reference][brute][T5]") {
    const float size = GENERATE(1e30f, 1.0f, 1e-6f, 1e-18f, 1e-30f, 1e-38f, 1e-44f);
    CAPTURE(size);
    const Ray ray{{size / 3.0f, size / 3.0f, -1.0f}, {0, 0, 1}, 0.0f, infinity};
    CHECK(is_hit(ray, {{0, 0, 0}, {size, 0, 0}, {0, size, 0}}));
}

TEST_CASE("in double a triangle of zero area is never hit", "[reference][brute][T8]") {
    const Ray ray{{1, 1, 5}, {0, 0, -1}, 0.0f, infinity};
    CHECK_FALSE(is_hit(ray, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}));
    CHECK_FALSE(is_hit(ray, {{1, 1, 0}, {1, 1, 0}, {2, 2, 0}}));
    CHECK_FALSE(is_hit(ray, {{0, 0, 0}, {1, 1, 0}, {3, 3, 0}}));
    // Here rounding lends the corners an area, as seen along the ray.
    const Ray oblique{{0.1f, 0.7f, 3.3f}, {0.9f, 0.3f, -2.3f}, 0.0f, infinity};
    CHECK_FALSE(is_hit(oblique, {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}));
}

TEST_CASE("in double no ray hits collinear corners", "[reference][brute][T8]") {
    const unsigned seed = 5;
    CAPTURE(seed);
    Random random(seed);
    std::uniform_int_distribution<int> steps(-8, 8);
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 a = glm::round(point_in_cube(random, 256.0f));
        const glm::vec3 step = glm::round(point_in_cube(random, 64.0f));
        const glm::vec3 b = a + step * static_cast<float>(steps(random));
        const glm::vec3 c = a + step * static_cast<float>(steps(random));
        const Ray ray = ray_through(point_in_cube(random, 500.0f), 0.5f * (a + b));
        REQUIRE_FALSE(is_hit(ray, {a, b, c}));
    }
}

TEST_CASE("in double a ray in the plane of the triangle misses it", "[reference][brute][T9]") {
    CHECK_FALSE(is_hit({{-1.0f, 0.25f, 0.0f}, {1, 0, 0}, 0.0f, infinity}, unit_triangle));
    CHECK_FALSE(is_hit({{-1.0f, -1.0f, 0.0f}, {1, 1, 0}, 0.0f, infinity}, unit_triangle));
}

TEST_CASE("in double minus zero gives the same bits as plus zero", "[reference][brute][T10]") {
    const float zero = GENERATE(0.0f, -0.0f);
    const float way = GENERATE(-1.0f, 1.0f);
    const Corners corners{{zero, zero, zero}, {1, zero, zero}, {zero, 1, zero}};
    // From the triangle itself, on an edge: t and u are zero.
    const Ray ray{{zero, 0.25f, zero}, {zero, zero, way}, zero, infinity};
    const Ray plain{{0.0f, 0.25f, 0.0f}, {0.0f, 0.0f, way}, 0.0f, infinity};
    CHECK(bits_of(nearest_hit(ray, corners)) == bits_of({0.0, 0.0, 0.25, 0}));
    CHECK(bits_of(nearest_hit(plain, unit_triangle)) == bits_of({0.0, 0.0, 0.25, 0}));
}

TEST_CASE("in double what is not finite misses", "[reference][brute]") {
    const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(), infinity, -infinity);
    Ray ray = down_at(0.25f, 0.25f);
    ray.origin.z = bad;
    CHECK_FALSE(is_hit(ray, unit_triangle));
    ray = down_at(0.25f, 0.25f);
    ray.direction.z = bad;
    CHECK_FALSE(is_hit(ray, unit_triangle));
    ray.direction = glm::vec3(0.0f);
    CHECK_FALSE(is_hit(ray, unit_triangle));
    ray = down_at(0.25f, 0.25f);
    ray.t_max = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(is_hit(ray, unit_triangle));
}

TEST_CASE("in double of equally near triangles the smallest index wins", "[reference][brute]") {
    Corners corners{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    for (int copy = 0; copy < 1000; ++copy) {
        const bool reversed = copy % 2 == 0;
        corners.insert(corners.end(),
                       {glm::vec3(0, 0, 0), reversed ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0),
                        reversed ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)});
    }
    CHECK(nearest_hit(down_at(0.25f, 0.5f), corners).triangle == 1);
}
