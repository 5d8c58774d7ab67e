#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "scene/load_scene.h"
#include "scene/shapes.h"
#include "support/compare_hits.h"
#include "support/expected_picture.h"
#include "support/gpu_hits.h"

#include "render/rays.h"
#include "render/show_hits.h"

#include <algorithm>

using namespace raysteps;

namespace {

// Rays from the middle of a sphere in all directions: each must hit.
std::vector<Ray> rays_from_inside(int count) {
    RandomNumbers numbers(8);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        rays.push_back({{0.0f, 0.0f, 0.0f}, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

} // namespace

TEST_CASE("with its culling in force the paper's listing lets every ray out of a closed mesh",
          "[02][exhibit]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 2.0f, 4));
    const std::vector<Ray> rays = rays_from_inside(1000);
    const auto context = make_context(ContextKind::automatic);
    CHECK(count_hits(gpu_hits(scene, rays, "paper_culling")) == 0);
    CHECK(count_hits(gpu_hits(scene, rays, "paper_repaired")) == 1000);
    CHECK(count_hits(gpu_hits(scene, rays, "watertight")) == 1000);
}

TEST_CASE("the 1e-6 of the paper's listing makes a small model vanish", "[02][exhibit]") {
    // Edges of about 1e-3: det is about their square, under 1e-6.
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 0.002f, 4));
    const std::vector<Ray> rays = rays_from_inside(1000);
    const auto context = make_context(ContextKind::automatic);
    CHECK(count_hits(gpu_hits(scene, rays, "paper_two_sided")) == 0);
    CHECK(count_hits(gpu_hits(scene, rays, "watertight")) == 1000);
}

TEST_CASE("deleting the redeclaration alone gives a wrong distance", "[02][exhibit]") {
    Mesh mesh;
    mesh.corners = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    mesh.normals.resize(3, {0.0f, 0.0f, 1.0f});
    for (glm::vec3& corner : mesh.corners) {
        corner += glm::vec3(0.0f, 4.0f, 3.0f);
    }
    const std::vector<Ray> rays{{{0.25f, 4.25f, 5.0f}, {0.0f, 0.0f, -1.0f}, -no_end, no_end}};
    const auto context = make_context(ContextKind::automatic);
    CHECK(gpu_hits(scene_of(mesh), rays, "paper_repaired").front().t == 2.0f);
    // dot(a, e2) / det with a = (0, 4, 3), e2 = (0, 1, 0), det = 1.
    CHECK(gpu_hits(scene_of(mesh), rays, "paper_wrong_depth").front().t == 4.0f);
}

TEST_CASE("the picture of chapter 02 is the expected one", "[02][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("knot:2", 1.0f);
    const SceneTextures textures = upload(scene);
    TraceRays trace({{"triangle", "triangle/watertight.glsl"}}, measure_limits());
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    const Image image = show_hits(rays, trace.closest_hits(rays, textures), textures, scene.camera,
                                  scene.background, "view/normals.glsl");
    CHECK(unexpected_pixels(image, "02_triangles") == 0);
}
