#include "catch.h"
#include "scene/shapes.h"
#include "support/gpu_hits.h"
#include "walk_hits.h"

using namespace raysteps;

// On the GPU, the walks are the same text as in the mirror; what differs is the compiler, and that
// walks are cut into launches.
TEST_CASE("every BVH walk on the GPU finds the hits of the loop over every triangle", "[06][gpu]") {
    const int seed = 61;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene =
        scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4), random_triangles(numbers, 300)));
    const auto context = make_context(ContextKind::automatic);
    for (const RayFamily& family : ray_families(numbers, scene.corners, 1000)) {
        const std::vector<Hit> expected = gpu_hits(scene, family.rays, "watertight");
        for (const std::string walk :
             {"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack"}) {
            for (const int rounds : {2048, 3}) {
                CAPTURE(family.name, walk, rounds);
                CHECK(count_different(expected,
                                      gpu_hits_of(scene, family.rays, walk, {}, rounds)) == 0);
            }
        }
    }
}

TEST_CASE("no triangle and one are answered by every BVH walk on the GPU", "[06][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene one = scene_of(triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
    const std::vector<Ray> rays{{{0, 0, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{5, 0, -1}, {0, 0, 1}, 0.0f, no_end}};
    for (const std::string walk :
         {"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack"}) {
        CAPTURE(walk);
        const std::vector<Hit> hits = gpu_hits_of(one, rays, walk);
        CHECK(hits[0].triangle == 0);
        CHECK(hits[0].t == 1.0f);
        CHECK(hits[1].triangle == no_triangle);
        CHECK(count_hits(gpu_hits_of(Scene{}, rays, walk)) == 0);
    }
}
