#include "reference/whitted.h"

#include "catch.h"
#include "error/error.h"
#include "little_scene.h"

#include <algorithm>
#include <cmath>

using namespace raysteps;

namespace {

// The colour of the one pixel whose ray goes from the eye to the target.
glm::vec3 middle_color(const Scene& scene, int max_bounces) {
    return render_whitted(scene, 1, 1, max_bounces).at(0, 0);
}

// The double is right to some 2^-48; rounding it to float moves it by at most 2^-24 of itself.
void check_color(const glm::vec3& color, const glm::vec3& expected) {
    CAPTURE(color.x, color.y, color.z, expected.x, expected.y, expected.z);
    for (int channel = 0; channel < 3; ++channel) {
        CHECK(std::abs(color[channel] - expected[channel]) <= expected[channel] / 8388608.0f);
    }
}

// A wall at z = 0 that a light at (3, 0, 4) shines on: there N.L = 0.8 at the origin.
Scene lit_wall() {
    Scene scene = empty_scene();
    add_wall(scene, 0.0f, diffuse_material({0.5f, 0.25f, 1.0f}));
    scene.lights = {{.position = {3, 0, 4}, .color = {1.0f, 2.0f, 0.5f}}};
    return scene;
}

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

TEST_CASE("a mirror shows what stands in front of it only if a bounce is left",
          "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = {1.0f, 1.0f, 1.0f};
    add_wall(scene, 0.0f, mirror_material({0.5f, 0.25f, 1.0f}));
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
    check_color(middle_color(scene, 1), {0.5f, 0.25f, 1.0f});
    add_wall(scene, 10.0f, shining_material({2.0f, 4.0f, 8.0f}));
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
    check_color(middle_color(scene, 1), {1.0f, 1.0f, 8.0f});
    check_color(middle_color(scene, 64), {1.0f, 1.0f, 8.0f});
}

TEST_CASE("a mirror with a diffuse colour shows both", "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.materials[0].specular = glm::vec3(0.5f);
    scene.materials[0].illumination_model = 3;
    scene.background = glm::vec3(0.5f);
    check_color(middle_color(scene, 0), glm::vec3(0.4f));
    check_color(middle_color(scene, 1), glm::vec3(0.65f));
}

TEST_CASE("two mirrors that face each other end at the limit of bounces", "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = glm::vec3(100.0f); // never seen
    Material mirror = mirror_material(glm::vec3(0.5f));
    mirror.emission = {1.0f, 0.0f, 2.0f};
    add_wall(scene, 0.0f, mirror);
    add_wall(scene, 10.0f, mirror);
    check_color(middle_color(scene, 0), {1.0f, 0.0f, 2.0f});
    check_color(middle_color(scene, 1), {1.5f, 0.0f, 3.0f});
    check_color(middle_color(scene, 2), {1.75f, 0.0f, 3.5f});
    check_color(middle_color(scene, 64), {2.0f, 0.0f, 4.0f}); // short of it by 2^-64
    check_color(middle_color(scene, 1000), {2.0f, 0.0f, 4.0f});
}

TEST_CASE("a mirror reflects about the shading normal as long as that stays above the surface",
          "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = {0.0f, 1.0f, 0.0f};
    add_wall(scene, 0.0f, mirror_material(glm::vec3(1.0f)));
    // Red, at x = 10, from below to far above.
    add_triangle(scene, {{10, -90, -40}, {10, 90, -40}, {10, 0, 90}}, {-1, 0, 0},
                 shining_material({1.0f, 0.0f, 0.0f}));
    const auto tilt = [&](const glm::vec3& normal) {
        std::fill(scene.normals.begin(), scene.normals.begin() + 3, normal);
    };
    tilt({0.6f, 0.0f, 0.8f}); // (0, 0, -1) goes to (0.96, 0, 0.28)
    check_color(middle_color(scene, 1), {1.0f, 0.0f, 0.0f});
    tilt({0.8f, 0.0f, 0.6f}); // (0.96, 0, -0.28) would go below: (0, 0, 1) instead
    check_color(middle_color(scene, 1), {0.0f, 1.0f, 0.0f});
}

TEST_CASE("row 0 of the image is its top and column 0 its left", "[reference][whitted]") {
    Scene scene = empty_scene();
    add_triangle(scene, {{-1, 0.5f, 0}, {-1, 1.5f, 0}, {-2, 1, 0}}, {0, 0, 1},
                 shining_material(glm::vec3(1.0f)));
    // At distance 5 the picture is 3.64 high and wide, so a pixel is 0.91: this one is at
    // (-1.36, 1.36).
    scene.corners = {{-1.9f, 0.9f, 0}, {-0.9f, 0.9f, 0}, {-1.4f, 2.5f, 0}};
    const Image image = render_whitted(scene, 4, 4, 0);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const bool is_lit = row == 0 && column == 0;
            CAPTURE(row, column);
            check_color(image.at(column, row), glm::vec3(is_lit ? 1.0f : 0.0f));
        }
    }
}

TEST_CASE("a surface never shadows itself however far out and however grazing the view",
          "[reference][whitted]") {
    const float offset = GENERATE(0.0f, 1e3f, 1e6f);
    const float height = GENERATE(5.0f, 0.01f);
    CAPTURE(offset, height);
    Scene scene = empty_scene();
    add_wall(scene, 0.0f, diffuse_material(glm::vec3(1.0f)));
    for (glm::vec3& corner : scene.corners) {
        corner += glm::vec3(offset, -offset, offset);
    }
    scene.camera.target = glm::vec3(offset, -offset, offset);
    scene.camera.eye =
        scene.camera.target + glm::vec3(0.0f, -5.0f, std::max(height, offset / 1e6f));
    scene.lights = {{.position = scene.camera.eye, .color = glm::vec3(1.0f)}};
    scene.background = glm::vec3(1.0f);
    for (const glm::vec3& color : render_whitted(scene, 48, 48, 0).pixels) {
        REQUIRE(color.x > 0.0f);
    }
}

TEST_CASE("only pixels beside an edge are sensitive to where their ray goes",
          "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = glm::vec3(1.0f);
    // Its left edge passes 2^-10 pixels right of the middle of column 8 of 17.
    const float pixel = 2.0f * 5.0f * std::tan(20.0f * 3.14159265f / 180.0f) / 17.0f;
    const float left = pixel / 1024.0f;
    add_triangle(scene, {{left, -50, 0}, {left, 50, 0}, {90, 0, 0}}, {0, 0, 1},
                 shining_material(glm::vec3(0.0f)));
    const std::vector<double> sensitivity = whitted_sensitivity(scene, 17, 17, 0, 1.0 / 256.0);
    for (std::size_t i = 0; i < sensitivity.size(); ++i) {
        REQUIRE(sensitivity[i] == (i % 17 == 8 ? 1.0 : 0.0));
    }
    for (const double change : whitted_sensitivity(scene, 17, 17, 0, 1.0 / 4096.0)) {
        REQUIRE(change == 0.0);
    }
}

TEST_CASE("a picture without pixels or with too many bounces is refused", "[reference][whitted]") {
    const Scene scene = empty_scene();
    CHECK_THROWS_AS(render_whitted(scene, 0, 4, 1), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, -1, 1), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, 4, -1), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, 4, 1001), InputError);
    CHECK_THROWS_AS(whitted_sensitivity(scene, 0, 4, 1, 0.1), InputError);
}
