#include "catch.h"
#include "contenders.h"
#include "gpu/context.h"
#include "measure/ray_kinds.h"
#include "mirrors.h"
#include "plane_families.h"
#include "render/generate_rays.h"
#include "scene/load_scene.h"
#include "scene/sample_scenes.h"
#include "scene/shapes.h"
#include "support/gpu_hits.h"
#include "support/ray_families.h"
#include "support/same_bits.h"

#include <algorithm>
#include <iostream>
#include <numeric>

using namespace raysteps;

namespace {

std::size_t count_different(std::span<const Hit> a, std::span<const Hit> b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        different += same_bits(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

std::size_t count_hits(std::span<const Hit> hits) {
    return static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle != no_triangle; }));
}

// The same triangles in another order.
Scene reordered(const Scene& scene, const std::vector<std::size_t>& order) {
    Mesh mesh;
    for (const std::size_t triangle : order) {
        for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            mesh.corners.push_back(scene.corners[corner]);
            mesh.normals.push_back(scene.normals[corner]);
        }
    }
    return scene_of(mesh);
}

// As they are, from the last to the first, and shuffled.
std::vector<Scene> in_three_orders(const Scene& scene, RandomNumbers& numbers) {
    std::vector<std::size_t> order(scene.corners.size() / 3);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Scene> scenes{scene};
    std::reverse(order.begin(), order.end());
    scenes.push_back(reordered(scene, order));
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1],
                  order[static_cast<std::size_t>(numbers.below(static_cast<int>(i)))]);
    }
    scenes.push_back(reordered(scene, order));
    return scenes;
}

std::vector<RayFamily> all_families(RandomNumbers& numbers, const Scene& scene, int rays) {
    std::vector<RayFamily> families = ray_families(numbers, scene.corners, rays);
    for (RayFamily& family : plane_families(numbers, scene.corners, rays)) {
        families.push_back(std::move(family));
    }
    return families;
}

// Every structure, three orders of the triangles, all families of rays; on the GPU, and where asked
// for by the mirror as well.
enum class By { gpu, gpu_and_mirror };

void check_families(const Scene& scene, int rays_a_family, By by) {
    const int seed = 41;
    CAPTURE(scene.name, seed);
    RandomNumbers numbers(seed);
    const auto context = make_context(ContextKind::automatic);
    Contenders contenders;
    std::size_t rays = 0;
    std::size_t exceptions = 0;
    for (const Scene& ordered : in_three_orders(scene, numbers)) {
        for (const RayFamily& family : all_families(numbers, ordered, rays_a_family)) {
            CAPTURE(family.name);
            const std::vector<Hit> expected = contenders.hits_of_loop(ordered, family.rays);
            CHECK(count_hits(expected) > family.rays.size() / 100);
            std::map<std::string, std::vector<Hit>> found =
                contenders.hits_of_all(ordered, family.rays);
            if (by == By::gpu_and_mirror) {
                found.merge(hits_of_mirrors(ordered, family.rays));
            }
            for (const auto& [name, hits] : found) {
                CAPTURE(name);
                const std::size_t different = count_different(hits, expected);
                CHECK(different == 0);
                exceptions += different;
                rays += hits.size();
            }
        }
    }
    std::cout << "agreement: " << scene.name << ": " << exceptions << " of " << rays
              << " walks differ from the loop\n";
}

Scene ball() {
    Scene scene = scene_of(sphere({0.3f, -0.2f, 0.1f}, 1.0f, 3));
    scene.name = "ball";
    return scene;
}

} // namespace

TEST_CASE("on a ball every structure finds the bits of the loop", "[agreement]") {
    check_families(ball(), 2500, By::gpu);
}

TEST_CASE("on random triangles every structure finds the bits of the loop", "[agreement]") {
    check_families(load_scene("soup:600", 1.0f), 2500, By::gpu);
}

TEST_CASE("on needles every structure finds the bits of the loop", "[agreement]") {
    check_families(load_scene("needles:300", 1.0f), 2500, By::gpu);
}

TEST_CASE("on every sample scene every structure finds the bits of the loop", "[agreement]") {
    const auto context = make_context(ContextKind::automatic);
    Contenders contenders;
    for (const SampleScene& sample : sample_scenes()) {
        const Scene scene = load_scene(std::string(sample.name), 1.0f);
        CAPTURE(scene.name);
        const std::vector<Ray> primary =
            read_rays(generate_rays(scene.camera, 32, 32, RayGeneration::direct));
        const std::vector<Hit> primary_hits = contenders.hits_of_loop(scene, primary);
        for (const RayKind& kind : ray_kinds(scene, primary, primary_hits, 1)) {
            CAPTURE(kind.name);
            const std::vector<Hit> expected = contenders.hits_of_loop(scene, kind.rays);
            for (const auto& [name, hits] : contenders.hits_of_all(scene, kind.rays)) {
                CAPTURE(name);
                CHECK(count_different(hits, expected) == 0);
            }
        }
    }
}

TEST_CASE("on a ball and a million rays a family every structure finds the bits of the loop",
          "[.][long]") {
    check_families(ball(), 1000000, By::gpu_and_mirror);
}

TEST_CASE("on needles and a million rays a family every structure finds the bits of the loop",
          "[.][long]") {
    check_families(load_scene("needles:300", 1.0f), 1000000, By::gpu_and_mirror);
}
