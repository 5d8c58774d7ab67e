#include "build_trees.h"
#include "bvh_hits.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

using namespace raysteps;

TEST_CASE("of coincident triangles the smallest one is hit by every BVH walk in any order",
          "[06][hard_case]") {
    const int seed = 21;
    CAPTURE(seed);
    const Mesh mesh = tripled(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3));
    BvhOptions options;
    options.leaf_triangles = 1; // copies come into leaves of their own
    for (const TriangleOrder order : all_orders) {
        RandomNumbers numbers(seed);
        const Scene scene = scene_of(reordered(mesh, order));
        for (const RayFamily& family : ray_families(numbers, scene.corners, 400)) {
            const BvhAgreement agreement =
                agreement_of(scene, bvh_for(scene, family.rays, options), family.rays);
            CAPTURE(static_cast<int>(order), family.name, agreement.exceptions);
            CHECK(agreement.exceptions.empty());
            CHECK(agreement.hits > 100);
        }
    }
}

TEST_CASE("of ten thousand copies of a triangle the first is hit by every BVH walk",
          "[06][hard_case]") {
    const Scene scene = scene_of(copies_of_a_triangle(10000));
    const std::vector<Ray> rays{{{0.25f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end},
                                {{0.5f, 0.25f, 3.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end}};
    const mirror::SceneBuffers buffers(scene);
    for (const BvhSplit split : all_splits) {
        const Bvh bvh = bvh_for(scene, rays, with_split(split));
        for_each_walk(buffers, bvh, scene.corners,
                      [&](const std::string& name, const auto& mirror) {
                          for (const int rounds : {whole_walk, 100}) {
                              for (const Hit& hit : hits_by(mirror, rays, rounds)) {
                                  CAPTURE(name, static_cast<int>(split), rounds);
                                  CHECK(hit.triangle == 0);
                              }
                          }
                      });
    }
}
