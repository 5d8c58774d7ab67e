#include "reference/embree/embree.h"

#include "catch.h"
#include "ray_families.h"
#include "reference/exact.h"
#include "rounding_bound.h"

#include <iostream>
#include <string>

using namespace raysteps;

TEST_CASE("Embree agrees with exact arithmetic wherever its rounding does not reach the edge",
          "[reference][agreement][embree]") {
    const auto [name, aim, half_side] =
        GENERATE(std::tuple<std::string, Aim, float>{"anywhere from inside", Aim::anywhere, 0.9f},
                 std::tuple<std::string, Aim, float>{"anywhere from around", Aim::anywhere, 4.0f},
                 std::tuple<std::string, Aim, float>{"at edges from inside", Aim::at_edges, 0.9f},
                 std::tuple<std::string, Aim, float>{"at corners", Aim::at_corners, 0.9f});
    const int seed = 20240819;
    CAPTURE(name, seed);
    RandomNumbers numbers(seed);
    const Mesh sphere = shared_edge_sphere();
    const std::vector<glm::vec3>& corners = sphere.corners;
    const EmbreeScene embree(corners, EmbreeMode::robust);
    const std::vector<Ray> rays = rays_at(sphere, aim, 20000, half_side, numbers);
    const std::vector<ReferenceHit> exacts = exact_nearest_hits(rays, corners);

    int hits = 0;
    int leaks = 0;
    int different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        const int expected = exacts[i].triangle;
        const Hit found = embree.nearest_hit(ray);
        CAPTURE(i, expected, found.triangle, exacts[i].t, found.t);
        hits += expected != no_triangle ? 1 : 0;
        if (found.triangle == expected && expected != no_triangle) {
            const auto three = corners_of(expected, corners);
            const double reach = rounding_bound(ray, three, unit_roundoff_of_float);
            REQUIRE(std::abs(found.u - exacts[i].u) <= reach);
            REQUIRE(std::abs(found.v - exacts[i].v) <= reach);
            REQUIRE(std::abs(found.t - exacts[i].t) <=
                    rounding_bound_of_t(ray, three, unit_roundoff_of_float, exacts[i].t));
        }
        if (found.triangle != expected) {
            ++different;
            leaks += found.triangle == no_triangle ? 1 : 0;
            const bool excused =
                is_too_close_to_call(ray, expected, corners, unit_roundoff_of_float) ||
                is_too_close_to_call(ray, found.triangle, corners, unit_roundoff_of_float);
            REQUIRE(excused);
        }
    }
    std::cout << "Embree against exact, " << name << ": " << rays.size() << " rays, " << hits
              << " hits, " << different << " other triangles at a shared edge or corner, of them "
              << leaks << " missed\n";
    CHECK(hits > 1000);
}
