#include "whitted_checks.h"

using namespace raysteps;

namespace {

// A triangle in the way from the origin to the light at (3, 0, 4), at this share of the way. It is
// small enough not to hide the origin from an eye at (-4, 0, 3).
void add_blocker(Scene& scene, float share) {
    const glm::vec3 middle = share * glm::vec3(3, 0, 4);
    const float size = share * 0.1f;
    add_triangle(scene,
                 {middle + glm::vec3(-size, -size, 0), middle + glm::vec3(size, -size, 0),
                  middle + glm::vec3(0, 2.0f * size, 0)},
                 {0, 0, 1}, diffuse_material(glm::vec3(1.0f)));
}

} // namespace

TEST_CASE("a ray that meets nothing has the colour of the background", "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = {0.25f, 0.5f, 0.75f};
    check_color(middle_color(scene, 4), {0.25f, 0.5f, 0.75f});
}

TEST_CASE("a surface shows its colour times the light times the cosine", "[reference][whitted]") {
    check_color(middle_color(lit_wall(), 0), {0.4f, 0.4f, 0.4f});
}

TEST_CASE("the lights add up and so does the emission", "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.lights.push_back({.position = {0, 0, 1}, .color = {1.0f, 1.0f, 1.0f}});
    scene.materials[0].emission = {0.0f, 0.25f, 3.0f};
    check_color(middle_color(scene, 0), {0.9f, 0.9f, 4.4f});
}

TEST_CASE("a light behind the surface gives nothing", "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.lights[0].position = {3, 0, -4};
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
}

TEST_CASE("a surface is lit on the side that is seen whatever its winding",
          "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.camera.eye = {0, 0, -5};
    check_color(middle_color(scene, 0), glm::vec3(0.0f)); // the light is on the other side
    scene.lights[0].position = {3, 0, -4};
    check_color(middle_color(scene, 0), {0.4f, 0.4f, 0.4f});
}

TEST_CASE("the normals of the corners are mixed for the shading", "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.lights = {{.position = {0, 0, 9}, .color = glm::vec3(1.0f)}};
    scene.normals = {{0.6f, 0.0f, 0.8f}, {0.6f, 0.0f, 0.8f}, {0.6f, 0.0f, 0.8f}};
    check_color(middle_color(scene, 0), {0.4f, 0.2f, 0.8f});
    for (glm::vec3& normal : scene.normals) {
        normal = -3.0f * normal; // turned over and made longer: they are turned back
    }
    check_color(middle_color(scene, 0), {0.4f, 0.2f, 0.8f});
    scene.normals.assign(3, glm::vec3(0.0f)); // no normal: that of the triangle
    check_color(middle_color(scene, 0), {0.5f, 0.25f, 1.0f});
}

TEST_CASE(
    "a light below the horizon of the triangle gives nothing even if the shading normal sees it",
    "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.normals.assign(3, glm::vec3(0.8f, 0.0f, 0.6f));
    scene.lights[0].position = {4, 0, -1};
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
}

TEST_CASE("what stands between the point and the light casts a shadow", "[reference][whitted]") {
    const float share = GENERATE(0.001f, 0.5f, 0.999f);
    CAPTURE(share);
    Scene scene = lit_wall();
    scene.camera.eye = {-4, 0, 3};
    add_blocker(scene, share);
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
}

TEST_CASE("what stands beside or beyond or at the light casts no shadow", "[reference][whitted]") {
    const float share = GENERATE(1.001f, 2.0f, 1.0f);
    CAPTURE(share);
    Scene scene = lit_wall();
    scene.camera.eye = {-4, 0, 3};
    add_blocker(scene, share);
    check_color(middle_color(scene, 0), {0.4f, 0.4f, 0.4f});
}
