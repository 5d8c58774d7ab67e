#include "scene/shapes.h"

#include "catch.h"
#include "scene/samples/samples.h"
#include "scene_tests.h"

#include <cmath>
#include <numbers>

using namespace raysteps;

TEST_CASE("a box has twelve triangles that enclose its volume", "[scene]") {
    const Mesh mesh = box({-1.0f, 0.0f, 2.0f}, {1.0f, 3.0f, 4.0f});
    REQUIRE(mesh.corners.size() == 36);
    REQUIRE(count_open_edges(mesh.corners) == 0);
    REQUIRE(signed_volume(mesh.corners) == 12.0); // whole numbers: exact
}

TEST_CASE("a tetrahedron is closed and its fronts are outside", "[scene]") {
    const Mesh mesh = tetrahedron({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    REQUIRE(mesh.corners.size() == 12);
    REQUIRE(count_open_edges(mesh.corners) == 0);
    REQUIRE(signed_volume(mesh.corners) == Approx(1.0 / 6.0));
}

TEST_CASE("an icosahedron has the volume that Euclid's solid has", "[scene]") {
    const Mesh mesh = icosahedron({1.0f, 2.0f, 3.0f}, 1.0f);
    REQUIRE(mesh.corners.size() == 60);
    REQUIRE(count_open_edges(mesh.corners) == 0);
    // Of edge length 1 it is 5 (3 + sqrt 5) / 12; the edge is 1 / sin(72 degrees) of the radius.
    const double edge = 1.0 / std::sin(0.4 * std::numbers::pi);
    const double volume = 5.0 * (3.0 + std::sqrt(5.0)) / 12.0 * edge * edge * edge;
    // Corners are rounded by up to 2^-23; the area of 10 times that is far below 1e-5.
    REQUIRE(signed_volume(mesh.corners) == Approx(volume).epsilon(1e-5));
}

TEST_CASE("a sphere is closed for every number of divisions", "[scene]") {
    for (int divisions = 1; divisions <= 17; ++divisions) {
        CAPTURE(divisions);
        const Mesh mesh = sphere({0.3f, -7.1f, 123.4f}, 0.77f, divisions);
        REQUIRE(mesh.corners.size() == static_cast<std::size_t>(60 * divisions * divisions));
        REQUIRE(count_open_edges(mesh.corners) == 0);
        REQUIRE(signed_volume(mesh.corners) > 0.0);
    }
}

TEST_CASE("a fine sphere nearly has the volume of a ball", "[scene]") {
    const double ball = 4.0 / 3.0 * std::numbers::pi;
    const double volume = signed_volume(sphere(glm::vec3(0.0f), 1.0f, 32).corners);
    // A triangle with edges of up to 1.3 / 32 lies below the sphere by at most their square over 6,
    // 2.8e-4; the volume is smaller by at most three times this share.
    REQUIRE(volume < ball);
    REQUIRE(volume > ball * (1.0 - 8.4e-4));
}

TEST_CASE("a tube around a circle is closed and nearly has the volume of a torus", "[scene]") {
    std::vector<TubeSection> sections;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 200;
        const glm::dvec3 radial{std::cos(angle), 0.0, std::sin(angle)};
        // right x up is the tangent (-sin, 0, cos)
        sections.push_back({3.0 * radial, radial, {0.0, 1.0, 0.0}});
    }
    const Mesh mesh = closed_tube(sections, 0.5, 100);
    REQUIRE(mesh.corners.size() == 120'000);
    REQUIRE(count_open_edges(mesh.corners) == 0);
    // Pappus: 2 pi 3 * pi 0.25. Inscribed polygons of n sides lose about 6.6 / n^2 of a circle's
    // area: 6.6e-4 for the tube, 1.7e-4 for the ring.
    const double torus = 2.0 * std::numbers::pi * 3.0 * std::numbers::pi * 0.25;
    REQUIRE(signed_volume(mesh.corners) < torus);
    REQUIRE(signed_volume(mesh.corners) > torus * (1.0 - 1e-3));
}

TEST_CASE("a torus knot is closed and has its fronts outside", "[scene]") {
    for (const int size : {1, 2, 5}) {
        CAPTURE(size);
        const Mesh mesh = torus_knot(size);
        REQUIRE(mesh.corners.size() == static_cast<std::size_t>(3 * 1024 * size * size));
        REQUIRE(count_open_edges(mesh.corners) == 0);
        REQUIRE(signed_volume(mesh.corners) > 0.0);
    }
}
