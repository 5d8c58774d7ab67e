#include "window/camera_text.h"

#include <glm/geometric.hpp>

#include <array>
#include <charconv>

namespace raysteps {

namespace {

// Radians: less than the angle by which a picture of 1000 pixels moves a pixel at its edge.
constexpr double smallest_tilt = 1e-3;

std::string shortest(float number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

void append(std::string& text, const glm::vec3& point) {
    for (const float number : {point.x, point.y, point.z}) {
        text += (text.empty() ? "" : ",") + shortest(number);
    }
}

// Whether up and the scene's up, seen from the eye, point apart.
bool is_tilted(const Camera& camera, const glm::vec3& scene_up) {
    const glm::dvec3 sight = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(sight, glm::dvec3(camera.up)));
    const glm::dvec3 level = glm::normalize(glm::cross(sight, glm::dvec3(scene_up)));
    // Not a number, where the camera looks along the scene's up: no up is kept then.
    return !(glm::distance(right, level) < smallest_tilt);
}

} // namespace

std::string camera_text(const Camera& camera, const glm::vec3& scene_up) {
    std::string numbers;
    append(numbers, camera.eye);
    append(numbers, camera.target);
    numbers += "," + shortest(camera.vertical_field_of_view);
    if (is_tilted(camera, scene_up)) {
        append(numbers, camera.up);
    }
    return "--camera " + numbers;
}

} // namespace raysteps
