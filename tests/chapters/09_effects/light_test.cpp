#include "catch.h"
#include "effect_pictures.h"

#include <algorithm>
#include <cmath>

using namespace raysteps;

namespace {

// A floor at y = 0 seen from straight above, from under the plate at y = 4: 4 wide, along x.
Scene floor_scene() {
    Scene scene;
    scene.camera = {{0, 3.9f, 0}, {0, 0, 0}, {0, 0, -1}, 0.0f};
    scene.camera.vertical_field_of_view =
        static_cast<float>(2.0 * std::atan(2.0 / 3.9) * 180.0 / 3.14159265358979);
    Material white;
    white.name = "floor";
    white.diffuse = glm::vec3(1.0f);
    return add_mesh(scene, quad({-40, 0, 40}, {40, 0, 40}, {40, 0, -40}, {-40, 0, -40}), white);
}

} // namespace

TEST_CASE("a penumbra is as wide as geometry says", "[09][soft_shadows]") {
    const auto context = make_context(ContextKind::automatic);
    // A lamp 2 wide, 10 above the floor; a plate 4 above the floor whose edge is at x = 0. Points
    // of the lamp at x = -1 and x = +1 cast the edge to x = 4 / 6 * (+1 and -1): the penumbra is
    // 4 / 3 wide.
    Scene scene = floor_scene();
    scene = add_mesh(scene, quad({0, 4, 20}, {30, 4, 20}, {30, 4, -20}, {0, 4, -20}), Material{});
    scene.lights = {{{0, 10, 0}, glm::vec3(1.0f), {2, 0, 0}, {0, 0, 0.02f}}};
    scene.camera.samples = 256;
    const int side = 64; // 4 wide: a pixel is 1/16
    const Image image = effect_picture(scene, side, "-antialiasing").image;
    int dark = 0;
    int bright = 0;
    for (int column = 0; column < side; ++column) {
        const float lit = image.at(column, side / 2).x;
        const double x = (column + 0.5) / 16.0 - 2.0;
        // Light from a point of the lamp at height 10: the cosine differs across the lamp by under
        // 1 part in 50, and 256 Halton points count a part of the lamp to about 3 / 256.
        const double cosine = 10.0 / std::sqrt(100.0 + x * x);
        const double open = std::clamp((2.0 / 3.0 - x) / (4.0 / 3.0), 0.0, 1.0);
        CAPTURE(x, lit);
        CHECK(std::abs(static_cast<double>(lit) - open * cosine) < 0.03);
        dark += lit == 0.0f ? 1 : 0;
        bright += lit > 0.97f * static_cast<float>(cosine) ? 1 : 0;
    }
    // Columns in full shadow: from x = 2/3 to 2, and as many in full light.
    CHECK(std::abs(dark - 21) <= 1);
    CHECK(std::abs(bright - 21) <= 2);
}

TEST_CASE("a highlight is brightest where the mirror would show the lamp", "[09][highlights]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = white_scene();
    Material glossy;
    glossy.name = "glossy";
    glossy.diffuse = glm::vec3(0.0f);
    glossy.specular = {0.5f, 0.25f, 1.0f};
    glossy.shininess = 32.0f;
    glossy.illumination_model = 2;
    scene = add_mesh(scene, facing_wall(0.0f, 9.0f), glossy);
    scene.lights = {{{0, 0, 4}, glm::vec3(1.0f)}};
    CHECK(effect_picture(scene, 1).image.at(0, 0).x == Approx(0.5f).epsilon(1e-4));
    // The lamp 3 to the side, 4 before: half the angle to it, whose cosine is 0.8, has the cosine
    // sqrt((1 + 0.8) / 2).
    scene.lights[0].position = {3, 0, 4};
    const double expected = std::pow(std::sqrt(0.9), 32.0);
    const glm::vec3 color = effect_picture(scene, 1).image.at(0, 0);
    CHECK(color.x == Approx(0.5 * expected).epsilon(5e-4)); // llvmpipe's pow, 32 times its log2
    CHECK(color.z == Approx(expected).epsilon(5e-4));
    CHECK(effect_picture(scene, 1, "-highlights").image.at(0, 0) == glm::vec3(0.0f));
}

TEST_CASE("several lights add up", "[09][lights]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 9.0f), Material{});
    scene.lights = {
        {{0, 0, 4}, {0.5f, 0, 0}}, {{0, 0, 8}, {0.25f, 0.5f, 0}}, {{3, 0, 4}, {0, 0, 1}}};
    const glm::vec3 color = effect_picture(scene, 1).image.at(0, 0);
    CHECK(color.x == Approx(0.8 * 0.75).epsilon(1e-5));
    CHECK(color.y == Approx(0.8 * 0.5).epsilon(1e-5));
    CHECK(color.z == Approx(0.8 * 0.8).epsilon(1e-5));
}

TEST_CASE("light comes through glass dimmed and not through what stands behind it",
          "[09][glass_shadows]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 9.0f), Material{});
    scene.lights = {{{0, 0, 8}, glm::vec3(1.0f)}};
    const glm::vec3 half(0.5f, 0.9f, 1.0f);
    const Scene glazed = add_mesh(scene, box({-1, -1, 5}, {1, 1, 6}), clear_glass(1.5f, half));
    const EffectPicture picture = effect_picture(glazed, 1);
    const double clear = 0.8 * 0.96 * 0.96;
    CHECK(picture.image.at(0, 0).x == Approx(0.5 * clear).epsilon(1e-4));
    CHECK(picture.image.at(0, 0).y == Approx(0.9 * clear).epsilon(1e-4));
    CHECK(picture.image.at(0, 0).z == Approx(clear).epsilon(1e-5));
    CHECK(picture.tally.behind_glass == 2);
    const Scene blocked = add_mesh(glazed, box({-1, -1, 6.5f}, {1, 1, 7}), Material{});
    CHECK(effect_picture(blocked, 1).image.at(0, 0) == glm::vec3(0.0f));
    CHECK(effect_picture(glazed, 1, "-glass_shadows").image.at(0, 0) == glm::vec3(0.0f));
}

TEST_CASE("a sky shows its three colours and their mixtures", "[09][sky]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = white_scene();
    scene.sky = Sky{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const auto seen = [&](const glm::vec3& direction) {
        scene.camera.target = scene.camera.eye + direction;
        scene.camera.up = {0, 0.5f, 1.25f};
        return effect_picture(scene, 1).image.at(0, 0);
    };
    CHECK(seen({0, 1, 0}).z == Approx(1.0f));
    CHECK(seen({1, 0, 0}).y == Approx(1.0f));
    CHECK(seen({0, -1, 0}).x == Approx(1.0f));
    CHECK(seen({0.8f, 0.6f, 0}).z == Approx(0.6f).epsilon(1e-4));
}

TEST_CASE("what lies in the sharp plane stays sharp and what does not is spread",
          "[09][depth_of_field]") {
    const auto context = make_context(ContextKind::automatic);
    // The left half of the view is a wall that glows, 4 before the eye.
    Scene scene = white_scene();
    scene.background = glm::vec3(0.0f);
    Material glow;
    glow.name = "glow";
    glow.diffuse = glm::vec3(0.0f);
    glow.emission = glm::vec3(1.0f);
    scene = add_mesh(scene, quad({-9, -9, 0}, {0, -9, 0}, {0, 9, 0}, {-9, 9, 0}), glow);
    scene.camera.aperture = 0.3f;
    scene.camera.samples = 64;
    const auto mixed = [&](float focus) {
        scene.camera.focus_distance = focus;
        const Image image = effect_picture(scene, 32, "-antialiasing").image;
        int count = 0;
        for (int column = 0; column < 32; ++column) {
            const float value = image.at(column, 16).x;
            count += value > 0.02f && value < 0.98f ? 1 : 0;
        }
        return count;
    };
    CHECK(mixed(4.0f) == 0);
    // Focused at 2, the disc of confusion at 4 is as wide as the lens: 0.3 of 1.41, 6.8 of 32
    // pixels; at its rim the light is within 2 percent of full or none for about a pixel.
    CHECK(mixed(2.0f) >= 5);
    CHECK(mixed(2.0f) <= 7);
}
