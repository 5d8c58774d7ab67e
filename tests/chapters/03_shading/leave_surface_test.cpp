#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"
#include "scene/shapes.h"
#include "support/mirror_hits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>

using namespace raysteps;

namespace {

using Mirror = mirror::walks::every_triangle<float>;

struct Outcome {
    long hits = 0;
    long rehits = 0;
    double farthest = 0.0; // how far origins moved, in sizes of the triangle
};

// Triangles of that size at that distance from the world's origin, hit from anywhere; from each hit
// a ray leaves in any direction on the same side, and must not meet its own triangle.
Outcome leave(RandomNumbers& numbers, float size, float offset, int count) {
    Outcome outcome;
    for (int i = 0; i < count; ++i) {
        const SeenSurface seen = any_triangle(numbers, size, offset);
        const std::vector<glm::vec3>& corners = seen.mesh.corners;
        const mirror::SceneBuffers buffers(add_mesh(Scene{}, seen.mesh, Material{}));
        Mirror mirror = mirror::mirror_of<Mirror>(buffers);
        const auto ray = mirror::to_mirror<Mirror>(seen.ray);
        const auto hit = mirror.closest_hit(ray);
        if (!mirror.is_hit(hit)) {
            continue; // aimed at an edge, and rounded past it
        }
        ++outcome.hits;
        const auto surface = mirror.surface_at(ray, hit);
        glm::vec3 direction = any_direction(numbers);
        if (glm::dot(direction, surface.geometric_normal) < 0.0f) {
            direction = -direction;
        }
        const auto leaving = mirror::to_mirror<Mirror>({surface.origin, direction, 0.0f, no_end});
        outcome.rehits += mirror.is_hit(mirror.closest_hit(leaving)) ? 1 : 0;
        const double moved =
            static_cast<double>(mirror.leaving_distance(corners[0], corners[1], corners[2]));
        outcome.farthest = std::max(outcome.farthest, moved / static_cast<double>(size));
    }
    return outcome;
}

} // namespace

TEST_CASE("a ray that leaves a triangle does not hit it again", "[03][hard_case]") {
    const int seed = 9;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const int count = 250000;
    for (const auto& [size, offset] :
         {std::pair{1.0f, 0.0f}, {1.0f, 1e3f}, {1e-3f, 0.0f}, {1.0f, 1e5f}}) {
        CAPTURE(size, offset);
        const Outcome outcome = leave(numbers, size, offset, count);
        std::cout << "03: triangles of size " << size << " at " << offset << ": " << outcome.rehits
                  << " of " << count << " rays hit their own again; origins moved by up to "
                  << outcome.farthest << " sizes\n";
        CHECK(outcome.hits > count / 10 * 9);
        CHECK(outcome.rehits == 0);
    }
}

TEST_CASE("a ray that leaves a triangle does not hit its neighbour in the plane",
          "[03][hard_case]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    long rehits = 0;
    long hits = 0;
    for (int i = 0; i < 100000; ++i) {
        const SeenSurface seen = any_parallelogram(numbers);
        const mirror::SceneBuffers buffers(add_mesh(Scene{}, seen.mesh, Material{}));
        Mirror mirror = mirror::mirror_of<Mirror>(buffers);
        const auto ray = mirror::to_mirror<Mirror>(seen.ray);
        const auto hit = mirror.closest_hit(ray);
        if (!mirror.is_hit(hit)) {
            continue;
        }
        ++hits;
        const auto surface = mirror.surface_at(ray, hit);
        glm::vec3 direction = any_direction(numbers);
        if (glm::dot(direction, surface.geometric_normal) < 0.0f) {
            direction = -direction;
        }
        const auto leaving = mirror::to_mirror<Mirror>({surface.origin, direction, 0.0f, no_end});
        rehits += mirror.is_hit(mirror.closest_hit(leaving)) ? 1 : 0;
    }
    std::cout << "03: " << rehits << " of " << hits << " rays hit a neighbour in the plane\n";
    CHECK(hits > 90000);
    CHECK(rehits == 0);
}

TEST_CASE("a surface close behind another is still hit", "[03][hard_case]") {
    // Two spheres of radius 1 and 1.00004: a ray that leaves the inner one outwards meets the outer
    // one.
    const Scene both = add_mesh(Scene{}, close_spheres(4e-5f), Material{});
    const int inner_triangles = triangle_count(both) / 2;
    const mirror::SceneBuffers buffers(both);
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    Mirror mirror_of_one = mirror;
    mirror_of_one.triangle_count = inner_triangles;
    const int seed = 10;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 2000; ++i) {
        // Onto the outside of the inner sphere, as a mirror between the two would see it.
        const glm::vec3 outside = 3.0f * any_direction(numbers);
        const auto ray = mirror::to_mirror<Mirror>({outside, -outside, 0.0f, no_end});
        const auto hit = mirror_of_one.closest_hit(ray);
        REQUIRE(mirror.is_hit(hit));
        const auto surface = mirror_of_one.surface_at(ray, hit);
        const auto leaving =
            mirror::to_mirror<Mirror>({surface.origin, surface.geometric_normal, 0.0f, no_end});
        const auto second = mirror.closest_hit(leaving);
        CAPTURE(i);
        REQUIRE(second.triangle >= inner_triangles);
    }
}
