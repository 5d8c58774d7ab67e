#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "scene/shapes.h"
#include "support/gpu_hits.h"
#include "support/mirror_hits.h"

#include <algorithm>

using namespace raysteps;

namespace {

long count_misses(std::span<const Hit> hits) {
    return std::count_if(hits.begin(), hits.end(),
                         [](const Hit& hit) { return hit.triangle == no_triangle; });
}

} // namespace

TEST_CASE("no ray leaves a closed mesh through an edge or a corner", "[02][hard_case]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 2.0f, 6);
    const Scene scene = scene_of(mesh);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Ray> at_edges = edge_aimed_rays(numbers, mesh, glm::vec3(0.9f), 100000);
    const std::vector<Ray> at_corners = corner_aimed_rays(numbers, mesh, glm::vec3(0.9f), 100000);
    CHECK(count_misses(gpu_hits(scene, at_edges, "watertight")) == 0);
    CHECK(count_misses(gpu_hits(scene, at_corners, "watertight")) == 0);
    // The same rays find the leaks of a test that has some: they are aimed well.
    CHECK(count_misses(gpu_hits(scene, at_edges, "moeller_trumbore")) > 1000);
    CHECK(count_misses(gpu_hits(scene, at_corners, "moeller_trumbore")) > 1000);

    const std::span<const Ray> some = std::span(at_corners).first(2000);
    CHECK(count_misses(mirror_hits<mirror::walks::every_triangle<double>>(scene, some)) == 0);
}
