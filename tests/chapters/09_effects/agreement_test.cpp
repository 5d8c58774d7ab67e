#include "catch.h"
#include "effect_pictures.h"
#include "reference/whitted.h"
#include "scene/samples/samples.h"

#include <glm/common.hpp>

#include <algorithm>
#include <iostream>

using namespace raysteps;

namespace {

// Lights are points and surfaces have no pictures here: the reference knows neither.
Scene plain(Scene scene) {
    for (Light& light : scene.lights) {
        light.across = glm::vec3(0.0f);
        light.along = glm::vec3(0.0f);
    }
    for (Material& material : scene.materials) {
        material.diffuse_map.clear();
    }
    scene.camera.samples = 1;
    return scene;
}

// Glass in water in a box, and a ball of amber beside a mirror.
Scene tank() {
    Scene scene;
    scene = add_mesh(scene, quad({-4, -1, 4}, {4, -1, 4}, {4, -1, -4}, {-4, -1, -4}),
                     matte("floor", {0.6f, 0.5f, 0.4f}));
    scene = add_mesh(scene, box({-1.1f, -0.9f, -0.6f}, {0.9f, 0.7f, 0.6f}),
                     glass("water", 1.33f, {0.7f, 0.9f, 0.95f}));
    scene = add_mesh(scene, box({-0.7f, -0.7f, -0.3f}, {-0.1f, 0.2f, 0.3f}),
                     glass("block", 1.5f, {0.95f, 0.9f, 0.8f}));
    scene =
        add_mesh(scene, sphere({0.4f, 0.0f, 0.0f}, 0.3f, 3), glass("bubble", 1.0f, glm::vec3(1)));
    scene = add_mesh(scene, sphere({1.6f, -0.4f, 0.4f}, 0.5f, 3),
                     glass("amber", 1.55f, {0.8f, 0.4f, 0.1f}));
    scene = add_mesh(scene,
                     quad({-2.5f, -0.9f, -1.5f}, {2.5f, -0.9f, -1.5f}, {2.5f, 1.5f, -1.5f},
                          {-2.5f, 1.5f, -1.5f}),
                     mirror_material("mirror", glm::vec3(0.05f), glm::vec3(0.8f)));
    scene = add_mesh(scene, icosahedron({-1.8f, -0.4f, 0.5f}, 0.5f),
                     glossy("glossy", {0.2f, 0.3f, 0.6f}, 0.6f, 30.0f));
    scene.lights = {{{-3, 5, 4}, {0.8f, 0.8f, 0.7f}}, {{4, 3, 2}, {0.3f, 0.3f, 0.4f}}};
    scene.camera = {{0.8f, 0.9f, 5.0f}, {0.1f, -0.1f, 0.0f}, {0, 1, 0}, 36.0f};
    scene.sky = Sky{{0.1f, 0.2f, 0.6f}, {0.7f, 0.7f, 0.7f}, {0.3f, 0.25f, 0.2f}};
    scene.name = "tank";
    return scene;
}

void check_agreement(const Scene& scene, int side) {
    CAPTURE(scene.name);
    const TreeLimits limits{.max_bounces = 5, .faintest = 0.0};
    const Image image = effect_picture(scene, side, "", {.max_bounces = 5, .faintest = 0.0f}).image;
    const Image expected = render_whitted(scene, side, side, limits);
    // In float a ray is off by about 2^-20 of its length, more after each bend; a thousandth of a
    // pixel is many times that. Where so small a move changes the colour, something begins or ends
    // in the pixel, and float and double may take different sides.
    const std::vector<double> sensitivity = whitted_sensitivity(scene, side, side, limits, 1e-3);
    int excused = 0;
    int different = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 apart = glm::abs(image.pixels[i] - expected.pixels[i]);
        const double error = static_cast<double>(std::max({apart.x, apart.y, apart.z}));
        if (sensitivity[i] > 0.002) {
            ++excused;
            continue;
        }
        largest = std::max(largest, error);
        different += error > 0.004 ? 1 : 0; // twice what a thousandth of a pixel changed
    }
    std::cout << "09: " << scene.name << ": " << excused << " of " << image.pixels.size()
              << " pixels hang on a thousandth of a pixel; the others are off by up to " << largest
              << "\n";
    CHECK(different == 0);
    CHECK(static_cast<std::size_t>(excused) < image.pixels.size() / 4);
}

} // namespace

TEST_CASE("glass mirrors highlights and skies agree with the recursive reference",
          "[09][reference]") {
    const auto context = make_context(ContextKind::automatic);
    check_agreement(tank(), 48);
    check_agreement(plain(load_scene("cornell_box", 1.0f)), 48);
    check_agreement(plain(load_scene("mirrors", 1.0f)), 32);
}
