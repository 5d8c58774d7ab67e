#include "reference/brute_force.h"
#include "reference/exact.h"

#include "catch.h"
#include "ray_families.h"
#include "rounding_bound.h"

#include <iostream>
#include <string>

using namespace raysteps;

namespace {

struct Family {
    std::string name;
    Aim aim;
    float half_side; // of the cube of origins: under 1.1 it lies inside the sphere of radius 2
    glm::vec3 offset;
};

} // namespace

TEST_CASE("double agrees with exact arithmetic wherever rounding does not reach the edge",
          "[reference][agreement]") {
    const Family family = GENERATE(Family{"anywhere from inside", Aim::anywhere, 0.9f, {}},
                                   Family{"anywhere from all around", Aim::anywhere, 4.0f, {}},
                                   Family{"at edges from inside", Aim::at_edges, 0.9f, {}},
                                   Family{"at corners from inside", Aim::at_corners, 0.9f, {}},
                                   Family{"at edges of a mesh at one million", Aim::at_edges, 0.9f,
                                          glm::vec3(1e6f, 0.0f, 0.0f)});
    const int seed = 20240818;
    CAPTURE(family.name, seed);
    RandomNumbers numbers(seed);
    const Mesh sphere = shared_edge_sphere();
    std::vector<glm::vec3> corners = sphere.corners;
    std::vector<Ray> rays = rays_at(sphere, family.aim, 20000, family.half_side, numbers);
    for (glm::vec3& corner : corners) {
        corner += family.offset;
    }
    for (Ray& ray : rays) {
        ray.origin += family.offset;
    }
    const std::vector<ReferenceHit> doubles = nearest_hits(rays, corners);
    const std::vector<ReferenceHit> exacts = exact_nearest_hits(rays, corners);

    int hits = 0;
    int leaks = 0;
    int false_hits = 0;
    int other_triangles = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        const int expected = exacts[i].triangle;
        const int found = doubles[i].triangle;
        CAPTURE(i, expected, found, exacts[i].t, doubles[i].t);
        hits += expected != no_triangle ? 1 : 0;
        if (found == expected && found != no_triangle) {
            const auto three = corners_of(found, corners);
            const double reach = rounding_bound(ray, three, unit_roundoff_of_double);
            REQUIRE(std::abs(doubles[i].u - exacts[i].u) <= reach);
            REQUIRE(std::abs(doubles[i].v - exacts[i].v) <= reach);
            REQUIRE(std::abs(doubles[i].t - exacts[i].t) <=
                    rounding_bound_of_t(ray, three, unit_roundoff_of_double, exacts[i].t));
        }
        if (found != expected) {
            leaks += found == no_triangle ? 1 : 0;
            false_hits += expected == no_triangle ? 1 : 0;
            other_triangles += found != no_triangle && expected != no_triangle ? 1 : 0;
            const bool excused =
                is_too_close_to_call(ray, expected, corners, unit_roundoff_of_double) ||
                is_too_close_to_call(ray, found, corners, unit_roundoff_of_double);
            REQUIRE(excused);
        }
    }
    std::cout << "double against exact, " << family.name << ": " << rays.size() << " rays, " << hits
              << " hits, " << leaks << " missed, " << false_hits << " false, " << other_triangles
              << " in the neighbour at a shared edge\n";
    CHECK(hits > 1000);
    if (family.half_side < 1.0f) {
        CHECK(leaks == 0); // the sphere is closed, and both tests are watertight
        CHECK(false_hits == 0);
    }
}

TEST_CASE("in double u and v and their sum stay in range", "[reference][brute][T13]") {
    const int seed = 13;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Mesh sphere = shared_edge_sphere();
    const std::vector<Ray> rays = rays_at(sphere, Aim::at_edges, 20000, 0.9f, numbers);
    for (const ReferenceHit& hit : nearest_hits(rays, sphere.corners)) {
        REQUIRE(hit.triangle != no_triangle);
        REQUIRE(hit.u >= 0.0);
        REQUIRE(hit.v >= 0.0);
        REQUIRE(hit.u + hit.v <= 1.0);
    }
}
