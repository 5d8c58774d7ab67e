#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"
#include "scene/shapes.h"
#include "support/mirror_hits.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
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

TEST_CASE("a ray that leaves a triangle starts as far from it as docs/numerics.md asks",
          "[03][hard_case]") {
    // Section 5: more than 19 e M along the normal, for triangles higher than 2^-18 of their
    // largest coordinate.
    const double e = 0x1p-24;
    const int seed = 12;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    double least = 1e9;
    for (int i = 0; i < 20000; ++i) {
        const float offset = std::exp2(16.0f * numbers.unit() - 8.0f);
        const SeenSurface seen = any_triangle(numbers, 1.0f, i % 2 == 0 ? 0.0f : offset);
        std::vector<glm::vec3> corners = seen.mesh.corners;
        const float thin = std::exp2(-16.0f * numbers.unit()); // the third corner comes to the edge
        corners[2] = glm::mix(0.5f * corners[0] + 0.5f * corners[1], corners[2], thin);
        const glm::dvec3 area = area_vector(corners[0], corners[1], corners[2]);
        double largest = 0.0;
        double longest = 0.0;
        for (std::size_t at = 0; at < 3; ++at) {
            const glm::dvec3 size = glm::abs(glm::dvec3(corners[at]));
            largest = std::max({largest, size.x, size.y, size.z});
            longest = std::max(
                longest, glm::distance(glm::dvec3(corners[at]), glm::dvec3(corners[(at + 1) % 3])));
        }
        if (glm::length(area) / longest < 0x1p-18 * largest) {
            continue;
        }
        const mirror::SceneBuffers buffers(add_mesh(Scene{}, mesh_of(corners), Material{}));
        Mirror mirror = mirror::mirror_of<Mirror>(buffers);
        Mirror::Hit hit;
        hit.t = 1.0f;
        hit.u = numbers.unit();
        hit.v = (1.0f - hit.u) * numbers.unit();
        hit.triangle = 0;
        const auto ray = mirror::to_mirror<Mirror>(seen.ray);
        const glm::dvec3 origin(mirror.surface_at(ray, hit).origin);
        const double away =
            std::abs(glm::dot(area, origin - glm::dvec3(corners[0]))) / glm::length(area);
        double reach = 0.0;
        for (const glm::vec3& corner : corners) {
            const glm::dvec3 from = glm::abs(glm::dvec3(corner) - origin);
            reach = std::max({reach, from.x, from.y, from.z});
        }
        CAPTURE(i, thin, offset);
        REQUIRE(away > 19.0 * e * reach);
        least = std::min(least, away / (19.0 * e * reach));
    }
    std::cout << "03: origins that leave a triangle are at least " << least
              << " times as far from it as they must be\n";
    CHECK(least < 4.0); // the triangles come close to what the proof is for
}

TEST_CASE("a triangle without area has finite normals, on the ray's side", "[03]") {
    const std::vector<glm::vec3> line{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    Mesh mesh{line, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1))};
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0.0f)}) {
        std::fill(mesh.normals.begin(), mesh.normals.end(), normal);
        const mirror::SceneBuffers buffers(add_mesh(Scene{}, mesh, Material{}));
        Mirror mirror = mirror::mirror_of<Mirror>(buffers);
        const auto ray = mirror::to_mirror<Mirror>({{0, 0, 5}, {0, 0, -1}, 0.0f, no_end});
        Mirror::Hit hit;
        hit.t = 5.0f;
        hit.u = 0.25f;
        hit.v = 0.5f;
        hit.triangle = 0;
        const auto surface = mirror.surface_at(ray, hit);
        CHECK(surface.geometric_normal == glm::vec3(0, 0, 1));
        CHECK(surface.normal == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("a triangle without area stands on its interpolated normal", "[03]") {
    const glm::vec3 slanted(0.0f, 0.6f, 0.8f);
    const Mesh mesh{{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, std::vector<glm::vec3>(3, slanted)};
    const mirror::SceneBuffers buffers(add_mesh(Scene{}, mesh, Material{}));
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    const auto ray = mirror::to_mirror<Mirror>({{0, 0, 5}, {0, 0, -1}, 0.0f, no_end});
    Mirror::Hit hit;
    hit.t = 5.0f;
    hit.u = 0.25f;
    hit.v = 0.5f;
    hit.triangle = 0;
    const auto surface = mirror.surface_at(ray, hit);
    // Weighing, scaling and dividing by the length round a component of at most 1 by 2^-24, six
    // times in all.
    CHECK(glm::distance(surface.geometric_normal, slanted) < 6.0f * 0x1p-24f * 2.0f);
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
