#include "build_trees.h"
#include "bvh_hits.h"
#include "catch.h"
#include "scene/shapes.h"
#include "support/hard_scenes.h"

using namespace raysteps;

namespace {

// All families of rays against one scene and one way to build. How many hits there are.
std::size_t check_families(int seed, const Scene& scene, const BvhOptions& options, int count) {
    RandomNumbers numbers(seed);
    std::size_t hits = 0;
    for (const RayFamily& family : ray_families(numbers, scene.corners, count)) {
        const Bvh bvh = bvh_for(scene, family.rays, options);
        const BvhAgreement agreement = agreement_of(scene, bvh, family.rays);
        CAPTURE(seed, static_cast<int>(options.split), family.name, agreement.exceptions);
        CHECK(agreement.exceptions.empty());
        hits += agreement.hits;
    }
    return hits;
}

BvhOptions with_large_leaves() {
    BvhOptions options;
    options.leaf_triangles = 16;
    options.traversal_cost = 20.0;
    return options;
}

} // namespace

TEST_CASE("all BVH walks find the hits of the loop on a closed mesh however it is split",
          "[06][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 2.0f, 5));
    for (const BvhSplit split : all_splits) {
        CHECK(check_families(1, scene, with_split(split), 400) > 2000); // of 3200
    }
}

TEST_CASE("all BVH walks find the hits of the loop among loose triangles however they are split",
          "[06][agreement]") {
    RandomNumbers numbers(2);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    for (const BvhSplit split : all_splits) {
        CHECK(check_families(2, scene, with_split(split), 400) > 2000);
    }
    CHECK(check_families(3, scene, with_large_leaves(), 400) > 2000);
}

TEST_CASE("all BVH walks find the hits of the loop on slivers", "[06][agreement]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_slivers(numbers, 300));
    CHECK(check_families(seed, scene, {}, 800) > 1500);
}

TEST_CASE("all BVH walks find the hits of the loop at every size and place", "[06][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    CHECK(check_families(5, moved(scene, 1e-6f, glm::vec3(0.0f)), {}, 400) > 2500);
    CHECK(check_families(6, moved(scene, 1e6f, glm::vec3(0.0f)), {}, 400) > 2500);
    CHECK(check_families(7, moved(scene, 1.0f, glm::vec3(1e4f, -1e4f, 1e4f)), {}, 400) > 2500);
    CHECK(check_families(8, moved(scene, 100.0f, glm::vec3(1e6f)), {}, 400) > 2500);
}

TEST_CASE("all BVH walks find the hits of the loop in a flat scene", "[06][agreement]") {
    const int seed = 9;
    CAPTURE(seed);
    for (int axis = 0; axis < 3; ++axis) {
        RandomNumbers numbers(seed);
        const Scene scene = scene_of(random_triangles(numbers, 300));
        CHECK(check_families(seed, flattened(scene, axis, 0.25f), {}, 400) > 500);
    }
}

TEST_CASE("all BVH walks find the hits of the loop on rays from far away", "[06][agreement]") {
    const int seed = 10;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    for (const float distance : {1e2f, 1e4f, 1e6f}) {
        const std::vector<Ray> rays = rays_from_far_away(numbers, scene.corners, distance, 2000);
        // The farther the origin, the more a triangle is padded for it.
        const BvhAgreement agreement = agreement_of(scene, bvh_for(scene, rays), rays);
        CAPTURE(distance, agreement.exceptions);
        CHECK(agreement.exceptions.empty());
        CHECK(agreement.hits > 500);
    }
}

TEST_CASE("BVH walks do not depend on the length of the direction", "[06][agreement]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    for (const float length : {1e-25f, 1e-10f, 1e10f, 1e25f}) {
        std::vector<Ray> rays = axis_parallel_rays(numbers, scene.corners, 1000);
        for (const Ray& ray : rays_with_a_zero(numbers, scene.corners, 1000)) {
            rays.push_back(ray);
        }
        for (Ray& ray : rays) {
            ray.direction *= length;
        }
        const BvhAgreement agreement = agreement_of(scene, bvh_for(scene, rays), rays);
        CAPTURE(length, agreement.exceptions);
        CHECK(agreement.exceptions.empty());
        CHECK(agreement.hits > 1000);
    }
}

TEST_CASE("a BVH of no triangle and of one answers every ray", "[06][hard_case]") {
    const int seed = 12;
    CAPTURE(seed);
    const Scene one = scene_of(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    CHECK(check_families(seed, one, {}, 400) > 1000);
    RandomNumbers numbers(seed);
    const std::vector<Ray> rays = random_rays(numbers, 100);
    const BvhAgreement agreement = agreement_of(Scene{}, build_bvh({}, {}), rays);
    CHECK(agreement.hits == 0);
    CHECK(agreement.exceptions.empty());
}
