#include "brute_force_checks.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

using namespace raysteps;

namespace {

std::array<std::uint64_t, 3> bits_of(const ReferenceHit& hit) {
    return {std::bit_cast<std::uint64_t>(hit.t), std::bit_cast<std::uint64_t>(hit.u),
            std::bit_cast<std::uint64_t>(hit.v)};
}

} // namespace

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

TEST_CASE("in double a ray in the plane of the triangle misses it", "[reference][brute][T9]") {
    CHECK_FALSE(is_hit_on_unit_triangle({{-1.0f, 0.25f, 0.0f}, {1, 0, 0}, 0.0f, infinity}));
    CHECK_FALSE(is_hit_on_unit_triangle({{-1.0f, -1.0f, 0.0f}, {1, 1, 0}, 0.0f, infinity}));
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
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
    ray = down_at(0.25f, 0.25f);
    ray.direction.z = bad;
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
    ray.direction = glm::vec3(0.0f);
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
    ray = down_at(0.25f, 0.25f);
    ray.t_max = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
}
