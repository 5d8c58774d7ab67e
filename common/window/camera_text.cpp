#include "window/camera_text.h"

#include <glm/geometric.hpp>

#include <array>
#include <charconv>
#include <initializer_list>

namespace raysteps {

namespace {

// Radians: less than the angle by which a picture of 1000 pixels moves a pixel at its edge.
constexpr double smallest_tilt = 1e-3;

std::string shortest(float number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

std::string join(std::initializer_list<float> numbers, const std::string& separator) {
    std::string text;
    for (const float number : numbers) {
        text += (text.empty() ? "" : separator) + shortest(number);
    }
    return text;
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
    const glm::vec3& eye = camera.eye;
    const glm::vec3& target = camera.target;
    std::string text = "--camera " + join({eye.x, eye.y, eye.z, target.x, target.y, target.z,
                                           camera.vertical_field_of_view},
                                          ",");
    if (is_tilted(camera, scene_up)) {
        text += "\n          tilted: --camera leaves that out, a scene file keeps it with up = [" +
                join({camera.up.x, camera.up.y, camera.up.z}, ", ") + "]";
    }
    return text;
}

} // namespace raysteps
