#include "catch.h"
#include "effect_pictures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace raysteps;

namespace {

glm::vec3 middle(const Scene& scene, const Quality& quality = {}) {
    return effect_picture(scene, 1, "", quality).image.at(0, 0);
}

Mesh slab(float back, float front) {
    return box({-9.0f, -9.0f, back}, {9.0f, 9.0f, front});
}

} // namespace

TEST_CASE("a clear slab lets through what endless reflections between its sides leave",
          "[09][glass]") {
    const auto context = make_context(ContextKind::automatic);
    // Before a white wall that glows, in the dark: of the light, T = (1 - R) / (1 + R) comes
    // through, with R = 0.04 for glass in air (Hecht, "Optics", section 4.6).
    Scene scene = white_scene();
    scene.background = glm::vec3(0.0f);
    Material glow;
    glow.diffuse = glm::vec3(0.0f);
    glow.emission = glm::vec3(1.0f);
    scene = add_mesh(scene, facing_wall(-3.0f, 90.0f), glow);
    scene = add_mesh(scene, slab(-1.0f, 0.0f), clear_glass(1.5f));
    // After 40 surfaces R^20 is left: nothing in float. 16 roundings of 2^-24 on the way.
    CHECK(middle(scene, {.max_bounces = 40, .faintest = 0.0f}).x ==
          Approx(0.96 / 1.04).epsilon(2e-6));
    // Without reflections that come back: (1 - R)^2.
    CHECK(middle(scene, {.max_bounces = 2, .faintest = 0.0f}).x ==
          Approx(0.96 * 0.96).epsilon(2e-6));
}

TEST_CASE("a ray leaves a slab parallel to itself and displaced as Snell says",
          "[09][glass][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    // A ray at 45 degrees through a slab 1 thick: behind it, the sky shows its direction (the
    // colour hangs on its height alone), and the displacement moves the edge of a wall.
    Scene scene;
    scene.camera = {{0, 4, 4}, {0, 0, 0}, {1, 0, 0}, 1.0f};
    scene.sky = Sky{{1, 1, 1}, {0, 0, 0}, {0, 0, 1}};
    const float direct = middle(add_mesh(scene, facing_wall(50.0f, 1.0f), Material{})).z;
    scene = add_mesh(scene, slab(-1.0f, 0.0f), clear_glass(1.5f));
    const Quality straight{.max_bounces = 2, .faintest = 0.3f};
    const double into = std::sin(std::atan(1.0)) / 1.5;
    const double cosine = std::sqrt(0.5);
    const double behind = std::sqrt(1.0 - into * into);
    const double across = (cosine - 1.5 * behind) / (cosine + 1.5 * behind);
    const double along = (behind - 1.5 * cosine) / (behind + 1.5 * cosine);
    const double reflected = 0.5 * (across * across + along * along);
    // The colour below is 1 from a height of -1/4 on: the same with and without the slab, but for
    // what two surfaces reflect.
    CHECK(
        middle(scene, straight).z ==
        Approx(static_cast<double>(direct) * (1.0 - reflected) * (1.0 - reflected)).epsilon(1e-5));
    // Behind the slab the ray comes down at y = -1 - 1 + 1 - tan(refraction): a wall that ends a
    // thousandth above that is missed, and one that ends a thousandth below is hit.
    const double height = -into / behind;
    for (const double aside : {-1e-3, 1e-3}) {
        CAPTURE(aside);
        Material black;
        black.diffuse = glm::vec3(0.0f);
        const auto top = static_cast<float>(height + aside);
        const Scene walled = add_mesh(scene,
                                      quad({-1, top - 1, -1.0001f}, {1, top - 1, -1.0001f},
                                           {1, top, -1.0001f}, {-1, top, -1.0001f}),
                                      black);
        CHECK((middle(walled, straight).z > 0.1f) == (aside < 0.0));
    }
}

TEST_CASE("in a white room glass is white and never brighter", "[09][glass][furnace]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [mesh, name] : {std::pair{sphere({0, 0, 0}, 0.6f, 8), "ball"},
                                     {box({-.4f, -.4f, -.4f}, {.4f, .4f, .4f}), "cube"}}) {
        CAPTURE(name);
        const Scene scene = add_mesh(white_scene(), mesh, clear_glass(1.5f));
        const Image image =
            effect_picture(scene, 24, "", {.max_bounces = 24, .faintest = 1e-7f}).image;
        float darkest = 1.0f;
        double sum = 0.0;
        for (const glm::vec3& pixel : image.pixels) {
            CHECK(pixel.x <= 1.0f + 1e-5f); // 64 roundings of sums and products at most
            darkest = std::min(darkest, pixel.x);
            sum += static_cast<double>(pixel.x);
        }
        // Light that is caught by total reflection for more than 24 bounces is lost: in a ball
        // hardly any.
        if (std::string(name) == "ball") {
            CHECK(sum / 576.0 > 0.999);
        }
    }
}

TEST_CASE("a mirror ball in a white room is white", "[09][mirrors][furnace]") {
    const auto context = make_context(ContextKind::automatic);
    Material silver;
    silver.diffuse = glm::vec3(0.0f);
    silver.specular = glm::vec3(1.0f);
    silver.illumination_model = 3;
    const Scene scene = add_mesh(white_scene(), sphere({0, 0, 0}, 0.6f, 4), silver);
    for (const glm::vec3& pixel : effect_picture(scene, 24).image.pixels) {
        CHECK(pixel == glm::vec3(1.0f));
    }
}

TEST_CASE("an absorbing slab dims light as Beer's law says", "[09][absorption]") {
    const auto context = make_context(ContextKind::automatic);
    // With the index of air nothing is reflected, so only absorption is left.
    for (const float thickness : {0.25f, 1.0f, 3.0f}) {
        CAPTURE(thickness);
        const glm::vec3 kept(0.5f, 0.9f, 1.0f);
        const Scene scene =
            add_mesh(white_scene(), slab(-thickness, 0.0f), clear_glass(1.0f, kept));
        const glm::vec3 color = middle(scene);
        // pow is exp2 of a product with log2, each a polynomial in llvmpipe: 3e-5 off at most here.
        CHECK(color.x == Approx(std::pow(0.5, static_cast<double>(thickness))).epsilon(5e-5));
        CHECK(color.y == Approx(std::pow(0.9, static_cast<double>(thickness))).epsilon(5e-5));
        CHECK(color.z == 1.0f);
    }
}

TEST_CASE("bodies of the same index in each other do not show", "[09][glass][nested]") {
    const auto context = make_context(ContextKind::automatic);
    const Quality quality{.max_bounces = 12, .faintest = 0.0f};
    Scene scene = white_scene();
    scene.sky = Sky{{1, 1, 0}, {0.2f, 0.4f, 0.6f}, {0, 0, 1}};
    scene = add_mesh(scene, slab(-2.0f, 0.0f), clear_glass(1.5f));
    const glm::vec3 alone = middle(scene, {.max_bounces = 8, .faintest = 0.0f});
    Material same = clear_glass(1.5f);
    same.name = "the same again";
    const Scene nested = add_mesh(scene, slab(-1.5f, -0.5f), same);
    const glm::vec3 with_inner = middle(nested, quality);
    for (int c = 0; c < 3; ++c) {
        CHECK(with_inner[c] == Approx(alone[c]).epsilon(1e-4)); // R^5 of deeper paths
    }
}

TEST_CASE("a bubble in glass and water in a glass bend light by the ratio of their indices",
          "[09][glass][nested]") {
    const auto context = make_context(ContextKind::automatic);
    // Slabs in a slab, straight on: at each border the part ((n1 - n2) / (n1 + n2))^2 is lost.
    for (const float inner : {1.0f, 1.33f, 2.4f}) {
        CAPTURE(inner);
        Scene scene = add_mesh(white_scene(), slab(-3.0f, 0.0f), clear_glass(1.5f));
        scene.background = glm::vec3(0.0f);
        Material glow;
        glow.diffuse = glm::vec3(0.0f);
        glow.emission = glm::vec3(1.0f);
        scene = add_mesh(scene, facing_wall(-5.0f, 90.0f), glow);
        scene = add_mesh(scene, slab(-2.0f, -1.0f), clear_glass(inner));
        const double outside = 0.2 / 1.0; // (1.5 - 1) / (1.5 + 1)
        const double n = static_cast<double>(inner);
        const double border = (1.5 - n) / (1.5 + n);
        const double through =
            std::pow(1.0 - outside * outside, 2.0) * std::pow(1.0 - border * border, 2.0);
        CHECK(middle(scene, {.max_bounces = 4, .faintest = 0.0f}).x ==
              Approx(through).epsilon(4e-6));
    }
}

TEST_CASE("a ray at the angle of total reflection is nobody's NaN", "[09][glass][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    // From within a block of glass, at angles around 41.8103 degrees on its upper side.
    for (const double degrees : {41.80, 41.809, 41.8103, 41.811, 41.82, 89.9}) {
        CAPTURE(degrees);
        Scene scene = white_scene();
        const double angle = degrees * 3.14159265358979 / 180.0;
        scene.camera = {
            {0, -1, 0},
            {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)) - 1.0f, 0.0f},
            {0, 0, 1},
            1e-4f};
        scene = add_mesh(scene, box({-50, -5, -50}, {50, 0, 50}), clear_glass(1.5f));
        const glm::vec3 color = middle(scene, {.max_bounces = 3, .faintest = 0.0f});
        CHECK(std::isfinite(color.x));
        CHECK(color.x <= 1.0f);
        CHECK(color.x >= 0.0f);
    }
}

TEST_CASE("an index of one and a full opacity and none are all right", "[09][glass][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(middle(add_mesh(white_scene(), slab(-1, 0), clear_glass(1.0f))) == glm::vec3(1.0f));
    Material half = clear_glass(1.0f);
    half.illumination_model = 2;
    half.opacity = 0.5f;
    CHECK(middle(add_mesh(white_scene(), facing_wall(0, 9), half)) == glm::vec3(0.5f));
    half.opacity = 0.0f;
    CHECK(middle(add_mesh(white_scene(), facing_wall(0, 9), half)) == glm::vec3(1.0f));
}

TEST_CASE("facing mirrors end at the depth limit", "[09][mirrors][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    Material silver;
    silver.diffuse = glm::vec3(0.0f);
    silver.specular = glm::vec3(1.0f);
    silver.emission = glm::vec3(0.125f);
    silver.illumination_model = 3;
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 100.0f), silver);
    scene = add_mesh(scene, facing_wall(8.0f, 100.0f), silver);
    for (const int depth : {0, 1, 64, 1000}) {
        CAPTURE(depth);
        CHECK(middle(scene, {.max_bounces = depth}) ==
              glm::vec3(0.125f * static_cast<float>(depth + 1)));
    }
}
