#include "catch.h"
#include "hard_cases/meshes.h"
#include "kd_hits.h"
#include "scene/shapes.h"

using namespace raysteps;

TEST_CASE("of coincident triangles the smallest one is hit by every walk in any order",
          "[05][hard_case]") {
    const int seed = 21;
    CAPTURE(seed);
    const Mesh mesh = tripled(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3));
    for (const TriangleOrder order : all_orders) {
        RandomNumbers numbers(seed);
        const Scene scene = scene_of(reordered(mesh, order));
        for (const RayFamily& family : ray_families(numbers, scene.corners, 500)) {
            const KdAgreement agreement =
                agreement_of(scene, tree_for(scene, family.rays), family.rays);
            CAPTURE(static_cast<int>(order), family.name, to_text(agreement));
            CHECK(agrees(agreement));
            CHECK(agreement.hits > 150);
        }
    }
}

TEST_CASE("ten thousand copies of a triangle make one leaf and the first copy is hit",
          "[05][hard_case]") {
    const int copies = 10000;
    const Scene scene = scene_of(copies_of_a_triangle(copies));
    KdOptions options = with_small_leaves();
    const KdTree tree = build_kd_tree(scene.corners, options);
    CHECK(tree.references.size() == static_cast<std::size_t>(copies));
    // The median sees only that no side is rid of anything, and gives up after two of those.
    options = with_median();
    options.bad_splits = 2;
    CHECK(build_kd_tree(scene.corners, options).references.size() <=
          10 * static_cast<std::size_t>(copies));
    const std::vector<Ray> rays{{{0.25f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end},
                                {{0.5f, 0.25f, 3.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end}};
    for (const int rounds : {1 << 30, 100}) {
        const KdAgreement agreement = agreement_of(scene, tree, rays, rounds);
        CHECK(agreement.hits == rays.size());
        CHECK(agrees(agreement));
    }
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(tree);
    for (const Hit& hit : hits_by(mirror::mirror_of<RopesWalk>(buffers, packed), rays)) {
        CHECK(hit.triangle == 0);
    }
}
