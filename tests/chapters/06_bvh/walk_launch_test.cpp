#include "catch.h"
#include "scene/shapes.h"
#include "structure/padding.h"
#include "support/nonsense_answers.h"
#include "walk_counted.h"

using namespace raysteps;

namespace {

// Long leaves, so that walks are cut in the middle of them.
BvhOptions with_long_leaves() {
    BvhOptions options;
    options.leaf_triangles = 16;
    options.traversal_cost = 20.0;
    return options;
}

// A tree as deep as there are triangles: each inner node has a leaf and all the rest. The triangles
// stand one behind the other along z, and the boxes hold all that is below.
Bvh chain_of(const Scene& scene) {
    Bvh bvh;
    const auto count = static_cast<std::int32_t>(scene.corners.size() / 3);
    const Box all = pad(bounds_of(scene.corners), padding_for(1000.0));
    for (std::int32_t i = 0; i + 1 < count; ++i) {
        bvh.order.push_back(i);
        if (i == 0) {
            bvh.nodes.push_back({all, 1, 0});
        }
        bvh.nodes.push_back({all, i, 1});
        bvh.nodes.push_back({all, 2 * i + 3, 0});
    }
    bvh.order.push_back(count - 1);
    bvh.nodes.back() = {all, count - 1, 1};
    return bvh;
}

// The same with the leaf of each pair in the second place, so that another child comes last.
Bvh turned(Bvh bvh) {
    for (std::size_t i = 1; i + 1 < bvh.nodes.size(); i += 2) {
        std::swap(bvh.nodes[i], bvh.nodes[i + 1]);
    }
    return bvh;
}

Scene slices(int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto z = static_cast<float>(i);
        mesh = join(mesh, triangle({-1, -1, z}, {1, -1, z}, {0, 1, z}));
    }
    return scene_of(mesh);
}

// What is wrong with the launches of these walks: a call that does more than its rounds, or one
// that leaves hit and place as they were.
template <class Mirror>
std::string faults_of_launches(Mirror mirror, std::span<const Ray> rays, int rounds) {
    for (const Ray& ray : rays) {
        const auto own = mirror::to_mirror<Mirror>(ray);
        auto walk = mirror.start_walk(own);
        while (!walk.ended) {
            const auto before = walk;
            mirror.observer = {};
            walk = mirror.go_on(walk, own, -mirror.farthest, rounds);
            const mirror::Counter done = mirror.observer;
            if (done.visits + done.tests > static_cast<unsigned>(rounds)) {
                return "more work than rounds";
            }
            if (!walk.ended && walk.place == before.place) {
                return "no progress";
            }
        }
    }
    return "";
}

} // namespace

TEST_CASE("a BVH walk that is cut into rounds gives the same bits", "[06][agreement]") {
    const int seed = 41;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    const Bvh bvh = build_bvh(scene.corners, with_long_leaves());
    for (const RayFamily& family : ray_families(numbers, scene.corners, 200)) {
        for (const int rounds : {1, 2, 7, 100}) {
            const BvhAgreement agreement = agreement_of(scene, bvh, family.rays, rounds);
            CAPTURE(family.name, rounds, agreement.exceptions);
            CHECK(agreement.exceptions.empty());
        }
    }
}

TEST_CASE("a launch of a BVH walk keeps to its rounds and comes farther", "[06]") {
    const int seed = 42;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    const mirror::SceneBuffers buffers(scene);
    const Bvh bvh = build_bvh(scene.corners, with_long_leaves());
    for (const RayFamily& family : ray_families(numbers, scene.corners, 100)) {
        for_each_counted_walk(
            buffers, bvh, scene.corners, [&](const std::string& name, const auto& mirror) {
                for (const int rounds : {1, 2, 7}) {
                    CAPTURE(family.name, name, rounds);
                    CHECK(faults_of_launches(mirror, family.rays, rounds).empty());
                }
            });
    }
}

TEST_CASE("a tree far deeper than the stack loses no hit", "[06][hard_case]") {
    const int seed = 43;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = slices(300);
    std::vector<Ray> rays;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 origin(0.1f, 0.1f, -1.0f + 302.0f * numbers.unit());
        rays.push_back({origin, {0.0f, 0.0f, i % 2 == 0 ? 1.0f : -1.0f}, 0.0f, no_end});
    }
    for (const Bvh& bvh : {chain_of(scene), turned(chain_of(scene))}) {
        for (const int rounds : {whole_walk, 1, 50}) {
            const BvhAgreement agreement = agreement_of(scene, bvh, rays, rounds);
            CAPTURE(rounds, agreement.exceptions);
            CHECK(agreement.exceptions.empty());
            CHECK(agreement.hits > 290);
        }
    }
}

TEST_CASE("a BVH walk that takes any hit stops where there is one and only there",
          "[06][agreement]") {
    const int seed = 44;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const mirror::SceneBuffers buffers(scene);
    const Bvh bvh = build_bvh(scene.corners, {});
    const std::vector<Ray> rays = segments(numbers, scene.corners, 2000);
    const std::vector<Hit> nearest = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    CHECK(count_hits(nearest) > 500);
    for_each_counted_walk(buffers, bvh, scene.corners, [&](const std::string& name, auto mirror) {
        using Mirror = decltype(mirror);
        std::size_t wrong = 0;
        unsigned tests_for_any = 0;
        unsigned tests_for_nearest = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto own = mirror::to_mirror<Mirror>(rays[i]);
            mirror.observer = {};
            const Hit any = mirror::from_mirror(mirror.any_hit(own));
            tests_for_any += mirror.observer.tests;
            mirror.observer = {};
            static_cast<void>(mirror.closest_hit(own));
            tests_for_nearest += mirror.observer.tests;
            const bool on_ray = any.t >= nearest[i].t && any.t <= rays[i].t_max;
            wrong += (any.triangle < 0) != (nearest[i].triangle < 0) || !on_ray ? 1 : 0;
        }
        CAPTURE(name, tests_for_any, tests_for_nearest);
        CHECK(wrong == 0);
        CHECK(10 * tests_for_any < 9 * tests_for_nearest);
    });
}

TEST_CASE("rays that are nonsense end in every BVH walk", "[06]") {
    RandomNumbers numbers(45);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    const mirror::SceneBuffers buffers(scene);
    const Bvh bvh = build_bvh(scene.corners, {});
    const std::vector<Ray> rays = nonsense_rays();
    for_each_walk(buffers, bvh, scene.corners, [&](const std::string& name, const auto& mirror) {
        CAPTURE(name);
        const std::vector<Hit> hits = hits_by(mirror, rays);
        CHECK(count_impossible(hits, rays, triangle_count(scene)) == 0);
        CHECK(count_hits(hits) > 0); // some of them are rays
        CHECK(count_different(hits_by(mirror, rays, 1), hits) == 0);
    });
}
