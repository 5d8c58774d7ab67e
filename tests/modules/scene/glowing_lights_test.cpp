#include "catch.h"
#include "scene/frame_scene.h"
#include "scene/load_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "scene/toml/toml_values.h"
#include "support/scratch_folder.h"

using namespace raysteps;

namespace {

Material lamp(const glm::vec3& emission) {
    Material material;
    material.name = "lamp";
    material.emission = emission;
    return material;
}

// A floor, and a lamp of 2 by 1 above it.
Scene lit_floor(const glm::vec3& emission) {
    Scene scene = add_mesh({}, quad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}), {});
    return add_mesh(std::move(scene), quad({-1, 3, -1}, {1, 3, -1}, {1, 3, 0}, {-1, 3, 0}),
                    lamp(emission));
}

} // namespace

TEST_CASE("a parallelogram that glows is a light with that area", "[scene][light]") {
    Scene scene = lit_floor({1.0f, 0.5f, 0.25f});
    const std::vector<Light> lights = glowing_lights(scene);
    REQUIRE(lights.size() == 1);
    CHECK(lights[0].position == glm::vec3(0.0f, 3.0f, -0.5f));
    CHECK(lights[0].color == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(glm::length(glm::cross(lights[0].across, lights[0].along)) == 2.0f);
    // Its corners are the position and half of the edges, forth and back.
    const glm::vec3 corner = lights[0].position - 0.5f * (lights[0].across + lights[0].along);
    CHECK(glm::abs(corner.x) == 1.0f);
    CHECK(corner.y == 3.0f);
    CHECK(scene.messages.empty());
}

TEST_CASE("what glows more than full light has the same colour at full light", "[scene][light]") {
    Scene scene = lit_floor({17.0f, 12.0f, 4.0f});
    const std::vector<Light> lights = glowing_lights(scene);
    REQUIRE(lights.size() == 1);
    CHECK(lights[0].color == glm::vec3(17.0f, 12.0f, 4.0f) / 17.0f);
}

TEST_CASE("a model that glows keeps the dim light and one that does not has both",
          "[scene][light]") {
    const Scene glowing = frame_scene(lit_floor(glm::vec3(1.0f)), 1.0f);
    const std::vector<Light> placed = place_lights(glowing.camera);
    REQUIRE(glowing.lights.size() == 2);
    CHECK(has_area(glowing.lights[0]));
    CHECK(glowing.lights[1].position == placed[1].position);
    const Scene dark = frame_scene(lit_floor(glm::vec3(0.0f)), 1.0f);
    REQUIRE(dark.lights.size() == 2);
    CHECK(dark.lights[0].position == place_lights(dark.camera)[0].position);
}

TEST_CASE("what glows in another shape is counted in a message", "[scene][light]") {
    Scene ball = add_mesh({}, sphere(glm::vec3(0.0f), 1.0f, 8), lamp(glm::vec3(1.0f)));
    const int triangles = triangle_count(ball);
    CHECK(glowing_lights(ball).size() <= most_glowing_lights);
    Scene kite = add_mesh({}, quad({0, 0, 0}, {1, 0, 0}, {3, 3, 0}, {0, 1, 0}), lamp({0, 1, 0}));
    CHECK(glowing_lights(kite).empty());
    REQUIRE(kite.messages.size() == 1);
    CHECK_THAT(kite.messages[0], starts_with_text("2 triangles glow (Ke)"));
    CHECK(triangles > 0);
}

TEST_CASE("at most sixteen glowing surfaces are lights", "[scene][light]") {
    Scene scene;
    for (int i = 0; i < 20; ++i) {
        const float x = 2.0f * static_cast<float>(i);
        scene = add_mesh(std::move(scene), quad({x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}),
                         lamp(glm::vec3(1.0f)));
    }
    CHECK(glowing_lights(scene).size() == most_glowing_lights);
    REQUIRE(scene.messages.size() == 1);
    CHECK_THAT(scene.messages[0], starts_with_text("8 triangles glow"));
}

TEST_CASE("a glowing model loads as the same scene from what is printed of it", "[scene][light]") {
    const ScratchFolder folder("glowing_lights");
    put_bytes(folder / "lamp.mtl", "newmtl lamp\nKe 3 2 1\n");
    put_bytes(folder / "lamp.obj", "mtllib lamp.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n"
                                   "v -2 -1 -2\nv 2 -1 -2\nv 0 -1 2\nf 5 6 7\nusemtl lamp\n"
                                   "f 1 2 3 4\n");
    const Scene scene = load_scene((folder / "lamp.obj").string(), 1.0f);
    REQUIRE(scene.lights.size() == 2);
    REQUIRE(has_area(scene.lights[0]));
    CHECK(scene.lights[0].color == glm::vec3(3.0f, 2.0f, 1.0f) / 3.0f);
    put_bytes(folder / "lamp.toml", to_toml(scene));
    const Scene again = load_scene((folder / "lamp.toml").string(), 1.0f);
    REQUIRE(again.lights.size() == 2);
    CHECK(again.lights[0].position == scene.lights[0].position);
    CHECK(again.lights[0].across == scene.lights[0].across);
    CHECK(again.lights[0].along == scene.lights[0].along);
}
