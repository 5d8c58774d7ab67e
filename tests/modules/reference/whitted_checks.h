#pragma once

#include "catch.h"
#include "little_scene.h"
#include "reference/whitted.h"

#include <cmath>

namespace raysteps {

// The colour of the one pixel whose ray goes from the eye to the target.
inline glm::vec3 middle_color(const Scene& scene, int max_bounces) {
    return render_whitted(scene, 1, 1, {.max_bounces = max_bounces}).at(0, 0);
}

// The double is right to some 2^-48; rounding it to float moves it by at most 2^-24 of itself, and
// the expected product by as much again.
inline void check_color(const glm::vec3& color, const glm::vec3& expected) {
    CAPTURE(color.x, color.y, color.z, expected.x, expected.y, expected.z);
    for (int channel = 0; channel < 3; ++channel) {
        CHECK(std::abs(color[channel] - expected[channel]) <= expected[channel] / 8388608.0f);
    }
}

// A wall at z = 0 that a light at (3, 0, 4) shines on: there N.L = 0.8 at the origin.
inline Scene lit_wall() {
    Scene scene = empty_scene();
    add_wall(scene, 0.0f, diffuse_material({0.5f, 0.25f, 1.0f}));
    scene.lights = {{.position = {3, 0, 4}, .color = {1.0f, 2.0f, 0.5f}}};
    return scene;
}

} // namespace raysteps
