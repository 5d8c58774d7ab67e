#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "reference/exact.h"
#include "support/compare_hits.h"
#include "support/gpu_hits.h"
#include "support/mirror_hits.h"

#include <algorithm>
#include <iostream>

using namespace raysteps;

namespace {

std::array<glm::vec3, 3> corners_of(const Scene& scene, int triangle) {
    const auto first = 3 * static_cast<std::size_t>(triangle);
    return {scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]};
}

} // namespace

TEST_CASE("the GPU and the mirror give the same bits", "[02][agreement]") {
    const int seed = 1;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 500));
    const std::vector<Ray> rays = random_rays(numbers, 20000);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Hit> watertight = gpu_hits(scene, rays, "watertight");
    CHECK(count_hits(watertight) > 1000);
    CHECK(count_different(watertight,
                          mirror_hits<mirror::walks::every_triangle<float>>(scene, rays)) == 0);
    CHECK(count_different(
              gpu_hits(scene, rays, "moeller_trumbore"),
              mirror_hits<mirror::triangle_tests::moeller_trumbore<float>>(scene, rays)) == 0);
}

TEST_CASE("the GPU hits the triangles that exact arithmetic hits", "[02][reference]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const std::vector<Ray> rays = random_rays(numbers, 20000);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Hit> hits = gpu_hits(scene, rays, "watertight");
    const std::vector<ReferenceHit> expected = exact_nearest_hits(rays, scene.corners);
    // Coordinates here are under 5 in size, seen from the origin of the ray, and sheared ones under
    // 10, each off by at most 3 roundings, so an edge's area by 16 * 10 * 10 * 2^-24; it is
    // compared with the whole triangle's, whose inverse can be anything. So the margin is scaled by
    // it, and rays that graze a triangle have their exception.
    const double area_error = 16.0 * 100.0 * 0x1p-24;
    std::size_t exceptions = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].triangle == expected[i].triangle) {
            continue;
        }
        ++exceptions;
        // The two part over one triangle: one that only the GPU hits, or else the expected one.
        const int found = hits[i].triangle;
        const bool false_hit =
            found != no_triangle && !exact_intersection(rays[i], corners_of(scene, found)).hit;
        const auto corners = corners_of(scene, false_hit ? found : expected[i].triangle);
        const glm::dvec3 normal = glm::cross(glm::dvec3(corners[1]) - glm::dvec3(corners[0]),
                                             glm::dvec3(corners[2]) - glm::dvec3(corners[0]));
        const glm::dvec3 direction(rays[i].direction);
        const double longest =
            std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
        const double projected = std::abs(glm::dot(normal, direction)) / longest;
        const double margin = exact_intersection(rays[i], corners).margin;
        CAPTURE(i, hits[i].triangle, expected[i].triangle);
        CHECK(margin <= area_error / projected);
    }
    std::cout << "02: " << exceptions << " of " << rays.size()
              << " rays differ from exact arithmetic, all within the derived bound\n";
    CHECK(exceptions < rays.size() / 1000);
}

TEST_CASE("how the triangles are dealt out to launches changes no bit", "[02][launches]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 1000));
    const std::vector<Ray> rays = random_rays(numbers, 2000);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Hit> at_once = gpu_hits(scene, rays, "watertight", 1000);
    for (const int rounds_per_launch : {1, 7, 64, 999}) {
        CAPTURE(rounds_per_launch);
        CHECK(count_different(at_once, gpu_hits(scene, rays, "watertight", rounds_per_launch)) ==
              0);
    }
}

TEST_CASE("a launch that outruns the loops of the platform is finished by others",
          "[02][launches]") {
    // The only triangle that a ray can hit is the last of more than any loop here can bear.
    const std::size_t count = 150000;
    Mesh mesh;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const float x = static_cast<float>(i % 1000);
        mesh.corners.insert(mesh.corners.end(),
                            {{x, 10.0f, 5.0f}, {x, 11.0f, 5.0f}, {x, 10.0f, 6.0f}});
    }
    mesh.corners.insert(mesh.corners.end(),
                        {{-1.0f, -1.0f, 5.0f}, {3.0f, -1.0f, 5.0f}, {-1.0f, 3.0f, 5.0f}});
    mesh.normals.resize(mesh.corners.size(), {0.0f, 0.0f, 1.0f});
    const std::vector<Ray> rays(8, {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end});
    const auto context = make_context(ContextKind::automatic);
    for (const Hit& hit : gpu_hits(scene_of(mesh), rays, "watertight", static_cast<int>(count))) {
        CHECK(hit.triangle == static_cast<int>(count) - 1);
        CHECK(hit.t == 5.0f);
    }
}
