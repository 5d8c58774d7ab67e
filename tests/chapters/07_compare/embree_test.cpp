#include "reference/embree/embree.h"

#include "basics/random_numbers.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "modules/reference/rounding_bound.h"
#include "reference/brute_force.h"

#include <cmath>

using namespace raysteps;

namespace {

constexpr double unit_roundoff = 1.0 / 16777216.0; // of float: 2^-24
constexpr int seed = 7;
constexpr float unbounded = 1e30f;

// Parts of a thread are 1,024 rays, packets 8: the last of both is not full.
constexpr std::size_t ray_count = 2051;

// From inside a sphere of radius 2, so that all hit, in any direction.
std::vector<Ray> rays_inside(float t_max) {
    RandomNumbers numbers(seed);
    std::vector<Ray> rays;
    while (rays.size() < ray_count) {
        const glm::vec3 origin = 0.5f * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, t_max});
    }
    return rays;
}

} // namespace

TEST_CASE("Embree finds the hits of the reference by single rays and by packets",
          "[07][embree][agreement]") {
    const auto mode = GENERATE(EmbreeMode::robust, EmbreeMode::fast);
    const auto call = GENERATE(EmbreeCall::one_by_one, EmbreeCall::packets);
    CAPTURE(seed, static_cast<int>(mode), static_cast<int>(call));
    const std::vector<glm::vec3> corners = latitude_sphere(2.0f, 8, 16).corners;
    const EmbreeScene embree(corners, mode);
    const std::vector<Ray> rays = rays_inside(unbounded);
    const std::vector<Hit> hits = embree.nearest_hits(rays, call);
    REQUIRE(hits.size() == rays.size());
    int same = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const ReferenceHit expected = nearest_hit(rays[i], corners);
        CAPTURE(i, hits[i].triangle, expected.triangle);
        if (hits[i].triangle != expected.triangle) { // only where rounding reaches an edge
            REQUIRE(is_too_close_to_call(rays[i], expected.triangle, corners, unit_roundoff));
            continue;
        }
        ++same;
        REQUIRE(std::abs(hits[i].t - expected.t) <=
                rounding_bound_of_t(rays[i], corners_of(expected.triangle, corners), unit_roundoff,
                                    expected.t));
    }
    CHECK(same > static_cast<int>(ray_count) * 9 / 10);
}

TEST_CASE("Embree tells for each ray whether there is any hit", "[07][embree]") {
    const auto call = GENERATE(EmbreeCall::one_by_one, EmbreeCall::packets);
    const EmbreeScene embree(latitude_sphere(2.0f, 8, 16).corners, EmbreeMode::robust);
    // Every third ray ends at t = 0.01, long before the sphere.
    std::vector<Ray> rays = rays_inside(unbounded);
    for (std::size_t i = 0; i < rays.size(); i += 3) {
        rays[i].t_max = 0.01f;
    }
    const std::vector<std::uint8_t> answers = embree.any_hits(rays, call);
    REQUIRE(answers.size() == rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(seed, i);
        REQUIRE(answers[i] == (i % 3 == 0 ? 0 : 1));
    }
}

TEST_CASE("Embree gives the same answers on any number of threads", "[07][embree]") {
    const EmbreeScene embree(latitude_sphere(2.0f, 8, 16).corners, EmbreeMode::robust);
    const std::vector<Ray> rays = rays_inside(unbounded);
    const std::vector<Hit> one = embree.nearest_hits(rays, EmbreeCall::one_by_one, 1);
    const std::vector<Hit> many = embree.nearest_hits(rays, EmbreeCall::one_by_one, 5);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(seed, i);
        REQUIRE(one[i].triangle == many[i].triangle);
        REQUIRE(one[i].t == many[i].t);
    }
}

TEST_CASE("Embree finds nothing where there is nothing", "[07][embree]") {
    const EmbreeScene embree(std::vector<glm::vec3>{}, EmbreeMode::robust);
    const Hit hit = embree.nearest_hit({glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f), 0.0f, 9.0f});
    CHECK(hit.triangle == no_triangle);
    CHECK(hit.t == 9.0f);
    CHECK(embree.nearest_hits({}, EmbreeCall::packets).empty());
}
