#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "kd_hits.h"
#include "scene/shapes.h"
#include "support/hard_scenes.h"
#include "support/nonsense_answers.h"

using namespace raysteps;

namespace {

// All families of rays against one scene and one way to build. How many hits there are.
std::size_t check_families(int seed, const Scene& scene, const KdOptions& options, int count) {
    RandomNumbers numbers(seed);
    const KdTree shaped = build_kd_tree(scene.corners, options);
    std::vector<RayFamily> families = ray_families(numbers, scene.corners, count);
    for (RayFamily& family : tree_families(numbers, shaped, scene.corners, count)) {
        families.push_back(std::move(family));
    }
    std::size_t hits = 0;
    for (const RayFamily& family : families) {
        // All these origins lie within the usual reach: the tree is the same.
        const KdTree tree = tree_for(scene, family.rays, options);
        const KdAgreement agreement = agreement_of(scene, tree, family.rays);
        CAPTURE(seed, family.name, to_text(agreement));
        CHECK(tree.padding == shaped.padding);
        CHECK(agrees(agreement));
        hits += agreement.hits;
    }
    return hits;
}

} // namespace

TEST_CASE("all walks find the hits of the loop over every triangle on a closed mesh",
          "[05][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 2.0f, 5));
    CHECK(check_families(1, scene, {}, 800) > 6000); // of 9600
    CHECK(check_families(2, scene, with_median(), 800) > 6000);
    CHECK(check_families(3, scene, with_small_leaves(), 800) > 6000);
}

TEST_CASE("all walks find the hits of the loop over every triangle among loose triangles",
          "[05][agreement]") {
    RandomNumbers numbers(4);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    CHECK(check_families(4, scene, {}, 800) > 6000);
    CHECK(check_families(5, scene, with_median(), 800) > 6000);
    CHECK(check_families(6, scene, with_small_leaves(), 800) > 6000);
}

TEST_CASE("all walks find the hits of the loop on slivers", "[05][agreement]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_slivers(numbers, 200));
    CHECK(check_families(seed, scene, {}, 800) > 1500);
    CHECK(check_families(seed, scene, with_small_leaves(), 800) > 1500);
}

TEST_CASE("all walks find the hits of the loop at every size and place", "[05][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    CHECK(check_families(8, moved(scene, 1e-6f, glm::vec3(0.0f)), {}, 400) > 2500);
    CHECK(check_families(9, moved(scene, 1e6f, glm::vec3(0.0f)), {}, 400) > 2500);
    CHECK(check_families(10, moved(scene, 1.0f, glm::vec3(1e4f, -1e4f, 1e4f)), {}, 400) > 2500);
    CHECK(check_families(11, moved(scene, 100.0f, glm::vec3(1e6f)), {}, 400) > 2500);
}

TEST_CASE("all walks find the hits of the loop in a flat scene", "[05][agreement]") {
    const int seed = 12;
    CAPTURE(seed);
    for (int axis = 0; axis < 3; ++axis) {
        RandomNumbers numbers(seed);
        const Scene scene = scene_of(random_triangles(numbers, 300));
        CHECK(check_families(seed, flattened(scene, axis, 0.25f), {}, 400) > 500);
    }
}

TEST_CASE("all walks find the hits of the loop on rays from far away", "[05][agreement]") {
    const int seed = 13;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    for (const float distance : {1e2f, 1e4f, 1e6f}) {
        const std::vector<Ray> rays = rays_from_far_away(numbers, scene.corners, distance, 2000);
        // The farther the origin, the more a triangle is padded for it.
        const KdAgreement agreement = agreement_of(scene, tree_for(scene, rays), rays);
        CAPTURE(distance, to_text(agreement));
        CHECK(agrees(agreement));
        CHECK(agreement.hits > 500);
    }
}

TEST_CASE("a walk that is cut into rounds gives the same bits", "[05][agreement]") {
    const int seed = 14;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    KdOptions options;
    options.leaf_triangles = 16; // long lists, so that walks are cut in the middle of them
    const KdTree tree = build_kd_tree(scene.corners, options);
    std::vector<RayFamily> families = ray_families(numbers, scene.corners, 200);
    for (RayFamily& family : tree_families(numbers, tree, scene.corners, 200)) {
        families.push_back(std::move(family));
    }
    for (const RayFamily& family : families) {
        for (const int rounds : {1, 2, 7, 100}) {
            const KdAgreement agreement = agreement_of(scene, tree, family.rays, rounds);
            CAPTURE(family.name, rounds, to_text(agreement));
            CHECK(agrees(agreement));
        }
    }
}

TEST_CASE("a walk that takes any hit stops where there is one and only there", "[05][agreement]") {
    const int seed = 15;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(build_kd_tree(scene.corners, {}));
    auto every_triangle = mirror::mirror_of<EveryTriangle>(buffers);
    const auto wrong_answers = [&](auto mirror) {
        using Mirror = decltype(mirror);
        std::size_t wrong = 0;
        for (const Ray& ray : segments(numbers, scene.corners, 2000)) {
            const Hit nearest = mirror::from_mirror(
                every_triangle.closest_hit(mirror::to_mirror<EveryTriangle>(ray)));
            const Hit any = mirror::from_mirror(mirror.any_hit(mirror::to_mirror<Mirror>(ray)));
            const bool one_of_them = any.t >= nearest.t && any.t <= ray.t_max;
            wrong += (any.triangle >= 0) != (nearest.triangle >= 0) || !one_of_them ? 1 : 0;
        }
        return wrong;
    };
    CHECK(wrong_answers(mirror::mirror_of<Restart>(buffers, packed)) == 0);
    CHECK(wrong_answers(mirror::mirror_of<Backtrack>(buffers, packed)) == 0);
    CHECK(wrong_answers(mirror::mirror_of<ShortStack>(buffers, packed)) == 0);
    CHECK(wrong_answers(mirror::mirror_of<RopesWalk>(buffers, packed)) == 0);
}

TEST_CASE("rays that are nonsense end all the same", "[05][agreement]") {
    RandomNumbers numbers(16);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(build_kd_tree(scene.corners, with_small_leaves()));
    const std::vector<Ray> rays = nonsense_rays();
    const auto check = [&](const std::string& name, const auto& mirror) {
        CAPTURE(name);
        const std::vector<Hit> hits = hits_by(mirror, rays);
        CHECK(count_impossible(hits, rays, triangle_count(scene)) == 0);
        CHECK(count_hits(hits) > 0); // some of them are rays
        CHECK(count_different(hits_by(mirror, rays, 1), hits) == 0);
    };
    check("kd_restart", mirror::mirror_of<Restart>(buffers, packed));
    check("kd_backtrack", mirror::mirror_of<Backtrack>(buffers, packed));
    check("kd_short_stack", mirror::mirror_of<ShortStack>(buffers, packed));
    check("kd_ropes", mirror::mirror_of<RopesWalk>(buffers, packed));
}
