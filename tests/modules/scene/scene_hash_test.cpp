#include "catch.h"
#include "scene/scene.h"

#include <cmath>
#include <functional>

using namespace raysteps;

namespace {

Scene hashed_scene() {
    Scene scene;
    scene.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    scene.triangle_materials = {0};
    scene.materials = {Material{}};
    scene.materials[0].diffuse_map = "/some/folder/wood.png";
    scene.lights = {{.position = {1, 2, 3}}};
    scene.background = {0.25f, 0.25f, 0.25f};
    return scene;
}

std::string hash_after(const std::function<void(Scene&)>& change) {
    Scene scene = hashed_scene();
    change(scene);
    return hash_of(scene);
}

} // namespace

TEST_CASE("the hash of a scene is the one that a few lines of Python give", "[scene][hash]") {
    CHECK(hash_of(hashed_scene()) == "4f0c549d0b8186ac");
}

TEST_CASE("whatever a ray or the light meets changes the hash", "[scene][hash]") {
    const std::string hash = hash_of(hashed_scene());
    CHECK(hash_after([](Scene& s) { s.corners[2].y = std::nextafter(1.0f, 2.0f); }) != hash);
    CHECK(hash_after([](Scene& s) { s.corners[0].x = -0.0f; }) != hash);
    CHECK(hash_after([](Scene& s) { s.normals[0].z = 0.5f; }) != hash);
    CHECK(hash_after([](Scene& s) { s.texture_coordinates = {{0, 0}, {0, 1}, {0, 0}}; }) != hash);
    CHECK(hash_after([](Scene& s) { s.texture_coordinates.resize(3); }) == hash); // all are zero
    CHECK(hash_after([](Scene& s) { s.materials[0].opacity = 0.5f; }) != hash);
    CHECK(hash_after([](Scene& s) { s.materials[0].diffuse_map = "stone.png"; }) != hash);
    CHECK(hash_after([](Scene& s) { s.lights[0].position.x = 0.0f; }) != hash);
    CHECK(hash_after([](Scene& s) { s.background.x = 0.0f; }) != hash);
    CHECK(hash_after([](Scene& s) { std::swap(s.corners[0], s.corners[1]); }) != hash);
}

TEST_CASE("who looks at a scene and what it is called do not change the hash", "[scene][hash]") {
    CHECK(hash_after([](Scene& s) {
              s.name = "other";
              s.camera.eye = {9, 9, 9};
              s.messages = {"a message"};
              s.materials[0].name = "oak";
              s.materials[0].diffuse_map = "other/place/wood.png";
          }) == hash_of(hashed_scene()));
}
