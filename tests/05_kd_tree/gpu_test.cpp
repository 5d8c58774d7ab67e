#include "catch.h"
#include "kd_hits.h"
#include "scene/shapes.h"

using namespace raysteps;

// On the GPU, the walks are the same text as in the mirror; what differs is the compiler, and that
// walks are cut into launches.
TEST_CASE("every walk on the GPU finds the hits of the loop over every triangle", "[05][gpu]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene =
        scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4), random_triangles(numbers, 300)));
    const auto context = make_context(ContextKind::automatic);
    for (const RayFamily& family : ray_families(numbers, scene.corners, 1000)) {
        const std::vector<Hit> expected = gpu_hits(scene, family.rays, "watertight");
        for (const std::string walk :
             {"kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"}) {
            for (const int rounds : {2048, 3}) {
                CAPTURE(family.name, walk, rounds);
                CHECK(count_different(expected,
                                      gpu_hits_of(scene, family.rays, walk, {}, rounds)) == 0);
            }
        }
    }
}
