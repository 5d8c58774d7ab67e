#pragma once

#include "basics/box.h"
#include "scene/scene.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <rapidcheck.h>

#include <cmath>

namespace raysteps {

inline double random_number(double lower, double upper) {
    const int steps = 1 << 20;
    return lower + (upper - lower) * *rc::gen::inRange(0, steps + 1) / steps;
}

inline glm::dvec3 random_point(double extent) {
    const double x = random_number(-extent, extent);
    const double y = random_number(-extent, extent);
    return {x, y, random_number(-extent, extent)};
}

inline glm::dvec2 random_move(double extent) {
    const double x = random_number(-extent, extent);
    return {x, random_number(-extent, extent)};
}

inline glm::dvec3 to_target(const Camera& camera) {
    return glm::dvec3(camera.target) - glm::dvec3(camera.eye);
}

inline double distance_of(const Camera& camera) {
    return glm::length(to_target(camera));
}

inline glm::dvec3 sight_of(const Camera& camera) {
    return glm::normalize(to_target(camera));
}

// Anywhere, but as the contract of Camera asks: with a distance, and an up that is not along it.
inline Camera random_camera() {
    Camera camera;
    camera.eye = glm::vec3(random_point(100.0));
    camera.target = glm::vec3(random_point(100.0));
    camera.up = glm::vec3(random_point(1.0));
    camera.vertical_field_of_view = static_cast<float>(random_number(1.0, 150.0));
    RC_PRE(distance_of(camera) > 0.1 && glm::length(camera.up) > 0.1f);
    RC_PRE(std::abs(glm::dot(sight_of(camera), glm::normalize(glm::dvec3(camera.up)))) < 0.99);
    return camera;
}

inline double largest_coordinate(const Camera& camera) {
    return glm::length(glm::dvec3(camera.target)) + distance_of(camera);
}

// Eye and up are rounded to floats: three coordinates each by up to 2^-24 of their size, so a point
// by e = sqrt(3) * 2^-24 * (|target| + distance).
inline double rounding_of(const Camera& camera) {
    return std::sqrt(3.0) * std::ldexp(1.0, -24) * largest_coordinate(camera);
}

// Eye, target and up are numbers; up is as long as 1 and square to the line of sight, but for its
// own rounding and that of the eye.
inline bool is_sound(const Camera& camera) {
    const double tolerance = std::ldexp(1.0, -22) + 2.0 * rounding_of(camera) / distance_of(camera);
    const glm::dvec3 up(camera.up);
    return is_finite(camera.eye) && is_finite(camera.target) && is_finite(camera.up) &&
           std::abs(glm::length(up) - 1.0) <= tolerance &&
           std::abs(glm::dot(up, sight_of(camera))) <= tolerance;
}

} // namespace raysteps
