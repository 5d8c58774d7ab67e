// Rays that pass exactly, without rounding, through the origin of space, where an edge lies. There
// a test in double computes sides of the edge that are 0 but for the rounding.
#include "basics/random_numbers.h"
#include "brute_force_checks.h"

#include <glm/common.hpp>

#include <cmath>
#include <iostream>

using namespace raysteps;

namespace {

// The direction d has 24 bits, so -2 d is a float and the ray passes through 0 at t = 2.
Ray ray_through_zero(RandomNumbers& numbers) {
    const glm::vec3 direction = numbers.in_cube();
    return {-2.0f * direction, direction, 0.0f, infinity};
}

// 20 bits, far below those of the ray, so that projecting the corner must round; and short enough
// that small multiples of it and their differences are floats.
glm::vec3 short_step(RandomNumbers& numbers) {
    const glm::vec3 step = glm::round(524288.0f * numbers.in_cube());
    return std::ldexp(1.0f, -35) * step;
}

float multiple(RandomNumbers& numbers) {
    return static_cast<float>(1 + numbers.below(8));
}

} // namespace

TEST_CASE("in double no ray slips through an edge that it passes exactly",
          "[reference][brute][T1]") {
    const int seed = 17;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int both = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = ray_through_zero(numbers);
        const glm::vec3 step = short_step(numbers);
        const glm::vec3 b = -multiple(numbers) * step;
        const glm::vec3 c = multiple(numbers) * step;
        // Two apexes, on the two sides of the plane through the ray and the edge.
        const glm::vec3 a = short_step(numbers);
        const glm::vec3 d = -a;
        CAPTURE(i);
        const bool first = is_hit(ray, {a, b, c});
        const bool second = is_hit(ray, {d, c, b});
        REQUIRE((first || second));
        both += first && second ? 1 : 0;
    }
    std::cout << "double: 20000 rays exactly through a shared edge, " << both
              << " hit both triangles, 0 neither\n";
}

TEST_CASE("in double u and v and their sum stay in range on an edge", "[reference][brute][T13]") {
    const int seed = 19;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = ray_through_zero(numbers);
        const glm::vec3 step = short_step(numbers);
        const Corners corners{short_step(numbers), -multiple(numbers) * step,
                              multiple(numbers) * step};
        const ReferenceHit hit = nearest_hit(ray, corners);
        hits += hit.triangle != no_triangle ? 1 : 0;
        CAPTURE(i);
        REQUIRE(hit.u >= 0.0);
        REQUIRE(hit.v >= 0.0);
        REQUIRE(hit.u + hit.v <= 1.0);
    }
    CHECK(hits > 5000);
}

TEST_CASE("in double no ray hits collinear corners", "[reference][brute][T8]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = ray_through_zero(numbers);
        const glm::vec3 step = short_step(numbers);
        CAPTURE(i);
        REQUIRE_FALSE(is_hit(
            ray, {-multiple(numbers) * step, multiple(numbers) * step, multiple(numbers) * step}));
    }
}
