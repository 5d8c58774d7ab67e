#include "catch.h"
#include "scene/shapes.h"
#include "support/whitted_by_gpu.h"

#include <glm/geometric.hpp>

using namespace raysteps;

namespace {

const glm::vec3 background(0.1f, 0.2f, 0.3f);

Material colored(const glm::vec3& diffuse) {
    Material material;
    material.diffuse = diffuse;
    return material;
}

Material mirror_of(const glm::vec3& specular) {
    Material material;
    material.diffuse = glm::vec3(0.0f);
    material.specular = specular;
    material.illumination_model = 3;
    return material;
}

// A camera at (0, 0, 4) that looks along -z, and a light at (0, 3, 4).
Scene empty_scene() {
    Scene scene;
    scene.background = background;
    scene.camera.eye = {0.0f, 0.0f, 4.0f};
    scene.camera.target = {0.0f, 0.0f, 0.0f};
    scene.lights = {{{0.0f, 3.0f, 4.0f}, {1.0f, 0.5f, 0.25f}}};
    scene.materials.resize(1);
    return scene;
}

// A square of side 2 * half across the z axis, its front towards the camera or away from it.
Mesh wall(float z, float half) {
    return quad({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z});
}

glm::vec3 middle(const Scene& scene, int max_bounces) {
    // An odd size has a pixel in the middle, whose ray runs along the z axis.
    const Image image = whitted_by_gpu(scene, 3, 3, max_bounces);
    return image.at(1, 1);
}

void check_color(const glm::vec3& color, const glm::vec3& expected) {
    CAPTURE(color.x, color.y, color.z, expected.x, expected.y, expected.z);
    // A handful of products of numbers up to 1, each rounded by 2^-24 at most.
    CHECK(glm::distance(color, expected) < 16.0f * 0x1p-24f);
}

} // namespace

TEST_CASE("a scene without triangles shows its background", "[03][shading]") {
    const auto context = make_context(ContextKind::automatic);
    check_color(middle(empty_scene(), 4), background);
}

TEST_CASE("a diffuse surface shows the cosine times both colours", "[03][shading]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = add_mesh(empty_scene(), wall(0.0f, 1.0f), colored({0.5f, 0.5f, 1.0f}));
    // The light stands 3 up and 4 before the wall: the cosine is 4 / 5.
    check_color(middle(scene, 4), glm::vec3(0.4f, 0.2f, 0.2f));
}

TEST_CASE("both sides of a surface are lit and only where the light is", "[03][shading]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = add_mesh(empty_scene(), wall(0.0f, 1.0f), colored(glm::vec3(1.0f)));
    scene.camera.eye = {0.0f, 0.0f, -4.0f};
    check_color(middle(scene, 4), glm::vec3(0.0f));
    scene.lights[0].position = {0.0f, 3.0f, -4.0f};
    check_color(middle(scene, 4), 0.8f * scene.lights[0].color);
}

TEST_CASE("what stands before the light casts a shadow and what stands behind it does not",
          "[03][shadow]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene lit = add_mesh(empty_scene(), wall(0.0f, 1.0f), colored(glm::vec3(1.0f)));
    // Boxes on the line from the middle of the wall to the light, at 1/2 and at 3/2 of the way.
    const glm::vec3 half(0.2f);
    const glm::vec3 before(0.0f, 1.5f, 2.0f);
    const glm::vec3 behind(0.0f, 4.5f, 6.0f);
    const Material grey = colored(glm::vec3(0.5f));
    check_color(middle(add_mesh(lit, box(before - half, before + half), grey), 0), glm::vec3(0.0f));
    check_color(middle(add_mesh(lit, box(behind - half, behind + half), grey), 0),
                0.8f * lit.lights[0].color);
}

TEST_CASE("a lamp does not stand in its own light", "[03][shadow]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = add_mesh(empty_scene(), wall(0.0f, 1.0f), colored(glm::vec3(1.0f)));
    const glm::vec3 lamp = scene.lights[0].position;
    scene = add_mesh(scene,
                     quad(lamp + glm::vec3(-0.5f, 0.0f, -0.5f), lamp + glm::vec3(0.5f, 0.0f, -0.5f),
                          lamp + glm::vec3(0.5f, 0.0f, 0.5f), lamp + glm::vec3(-0.5f, 0.0f, 0.5f)),
                     colored(glm::vec3(0.5f)));
    check_color(middle(scene, 0), 0.8f * scene.lights[0].color);
}

TEST_CASE("a surface that glows shows its glow", "[03][shading]") {
    const auto context = make_context(ContextKind::automatic);
    Material lamp = colored(glm::vec3(0.0f));
    lamp.emission = {0.25f, 0.5f, 2.0f};
    check_color(middle(add_mesh(empty_scene(), wall(0.0f, 1.0f), lamp), 0), lamp.emission);
}

TEST_CASE("a mirror shows what it faces in its own colour", "[03][mirror]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = add_mesh(empty_scene(), wall(0.0f, 1.0f), mirror_of({1.0f, 0.5f, 0.25f}));
    check_color(middle(scene, 1), background * glm::vec3(1.0f, 0.5f, 0.25f));
    check_color(middle(scene, 0), glm::vec3(0.0f));
}

TEST_CASE("facing mirrors end at the depth limit with what was gathered until then",
          "[03][mirror]") {
    const auto context = make_context(ContextKind::automatic);
    // The camera stands between two mirrors that glow: each bounce adds as much as the last,
    // weighed by 1.
    Material mirror = mirror_of(glm::vec3(1.0f));
    mirror.emission = glm::vec3(0.125f);
    Scene scene = add_mesh(empty_scene(), wall(0.0f, 100.0f), mirror);
    scene = add_mesh(scene, wall(8.0f, 100.0f), mirror);
    for (const int depth : {0, 1, 64, 1000}) {
        CAPTURE(depth);
        const Image image = whitted_by_gpu(scene, 1, 1, depth);
        CHECK(image.at(0, 0) == glm::vec3(0.125f * static_cast<float>(depth + 1)));
    }
}

TEST_CASE("each kind of ray is counted and dead pixels ask for none", "[03][counts]") {
    const auto context = make_context(ContextKind::automatic);
    // A wall that covers the picture's left half and is a mirror: half of the rays go on, once.
    const Scene scene = add_mesh(
        empty_scene(),
        quad({-9.0f, -9.0f, 0.0f}, {0.0f, -9.0f, 0.0f}, {0.0f, 9.0f, 0.0f}, {-9.0f, 9.0f, 0.0f}),
        mirror_of(glm::vec3(1.0f)));
    WhittedRenderer renderer(scene, upload(scene), {{"triangle", "triangle/watertight.glsl"}},
                             measure_limits());
    renderer.render(scene.camera, 16, 16, 4);
    CHECK(renderer.ray_counts().camera == 256);
    CHECK(renderer.ray_counts().shadow == 128);
    CHECK(renderer.ray_counts().mirror == 128);
}
