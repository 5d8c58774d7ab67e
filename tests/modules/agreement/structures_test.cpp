#include "catch.h"
#include "contenders.h"
#include "gpu/context.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "measure/ray_kinds.h"
#include "mirrors.h"
#include "plane_families.h"
#include "render/rays.h"
#include "scene/load_scene.h"
#include "scene/samples/sample_scenes.h"
#include "scene/shapes.h"
#include "support/gpu_hits.h"
#include "support/walk_hits.h"

#include <algorithm>
#include <iostream>

using namespace raysteps;

namespace {

// As they are, from the last to the first, and shuffled.
std::vector<Scene> in_three_orders(const Scene& scene) {
    Mesh mesh;
    mesh.corners = scene.corners;
    mesh.normals = scene.normals;
    return {scene, scene_of(reordered(mesh, TriangleOrder::backward)),
            scene_of(reordered(mesh, TriangleOrder::shuffled))};
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
    Contenders contenders(measure_limits());
    std::size_t rays = 0;
    std::size_t exceptions = 0;
    for (const Scene& ordered : in_three_orders(scene)) {
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

// The rays that a renderer traces in the scene, and some at edges and corners: only there do
// triangles share a distance, and the number of a triangle decides.
std::vector<RayFamily> renderer_families(Contenders& contenders, const Scene& scene) {
    const std::vector<Ray> primary =
        read_rays(generate_rays(scene.camera, 32, 32, RayGeneration::direct));
    const std::vector<Hit> primary_hits = contenders.hits_of_loop(scene, primary);
    std::vector<RayFamily> families;
    for (RayKind& kind : ray_kinds(scene, primary, primary_hits, 1)) {
        families.push_back({kind.name, std::move(kind.rays)});
    }
    RandomNumbers numbers(43);
    families.push_back({"at edges", rays_at_edges(numbers, scene.corners, 256)});
    families.push_back({"at corners", rays_at_corners(numbers, scene.corners, 256)});
    return families;
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
    Contenders contenders(measure_limits());
    for (const SampleScene& sample : sample_scenes()) {
        const Scene scene = load_scene(std::string(sample.name), 1.0f);
        CAPTURE(scene.name);
        const std::vector<RayFamily> families = renderer_families(contenders, scene);
        float reach = 0.0f;
        for (const RayFamily& family : families) {
            reach = std::max(reach, reach_of(family.rays, scene.corners));
        }
        const Contenders::Built built = contenders.build(scene, reach);
        for (const RayFamily& family : families) {
            CAPTURE(family.name);
            const std::vector<Hit> expected = contenders.hits_of_loop(scene, family.rays);
            for (const auto& [name, hits] : contenders.hits_of_all(built, family.rays)) {
                CAPTURE(name);
                CHECK(count_different(hits, expected) == 0);
            }
        }
    }
}

TEST_CASE("launches of few rounds give the bits of the loop in every structure",
          "[agreement][launches]") {
    const int seed = 42;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene =
        scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4), random_triangles(numbers, 300)));
    const auto context = make_context(ContextKind::automatic);
    Contenders contenders(3);
    for (const RayFamily& family : all_families(numbers, scene, 1000)) {
        CAPTURE(family.name);
        const std::vector<Hit> expected = contenders.hits_of_loop(scene, family.rays);
        CHECK(count_hits(expected) > family.rays.size() / 100);
        for (const auto& [name, hits] : contenders.hits_of_all(scene, family.rays)) {
            CAPTURE(name);
            CHECK(count_different(hits, expected) == 0);
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
