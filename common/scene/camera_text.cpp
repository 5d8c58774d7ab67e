#include "scene/camera_text.h"

#include "basics/error.h"
#include "basics/text.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

Camera parse_camera(const std::string& text, const Camera& start) {
    const std::optional<std::vector<float>> given = parse_numbers(text);
    const std::size_t count = given ? given->size() : 0;
    if (count != 6 && count != 7 && count != 10) {
        throw InputError("--camera " + text +
                         ": a camera is six numbers, eye x,y,z and target x,y,z, and perhaps the "
                         "vertical field of view in degrees, as in 0,1,5,0,0,0,40, and then up "
                         "x,y,z.");
    }
    const std::vector<float>& numbers = *given;
    Camera camera = start;
    camera.eye = {numbers[0], numbers[1], numbers[2]};
    camera.target = {numbers[3], numbers[4], numbers[5]};
    if (numbers.size() >= 7) {
        camera.vertical_field_of_view = numbers[6];
    }
    if (numbers.size() == 10) {
        camera.up = {numbers[7], numbers[8], numbers[9]};
    }
    if (camera.vertical_field_of_view <= 0.0f || camera.vertical_field_of_view >= 180.0f) {
        throw InputError("--camera " + text +
                         ": the field of view is over 0 and under 180 degrees. Take another.");
    }
    const glm::dvec3 forward = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    if (glm::length(forward) == 0.0) {
        throw InputError("--camera " + text +
                         ": eye and target are the same point. Move one of them.");
    }
    const glm::dvec3 direction = glm::normalize(forward);
    const glm::dvec3 up(camera.up);
    if (glm::length(glm::cross(direction, up)) > 1e-6 * glm::length(up)) {
        return camera;
    }
    if (numbers.size() == 10) {
        throw InputError("--camera " + text +
                         ": up lies in the direction of view. Take another up.");
    }
    // A camera that looks straight up or down needs another direction to call up.
    camera.up =
        std::abs(direction.y) > 0.5 ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return camera;
}

namespace {

// Radians: less than the angle by which a picture of 1000 pixels moves a pixel at its edge.
constexpr double smallest_tilt = 1e-3;

void append(std::string& text, const glm::vec3& point) {
    for (const float number : {point.x, point.y, point.z}) {
        text += (text.empty() ? "" : ",") + shortest_text(number);
    }
}

// Whether up and the scene's up, seen from the eye, point apart.
bool is_tilted(const Camera& camera, const glm::vec3& scene_up) {
    const glm::dvec3 sight = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(sight, glm::dvec3(camera.up)));
    const glm::dvec3 level = glm::normalize(glm::cross(sight, glm::dvec3(scene_up)));
    // NaN where the camera looks along the scene's up: no up is kept then.
    return !(glm::distance(right, level) < smallest_tilt);
}

} // namespace

std::string camera_text(const Camera& camera, const glm::vec3& scene_up) {
    std::string numbers;
    append(numbers, camera.eye);
    append(numbers, camera.target);
    numbers += "," + shortest_text(camera.vertical_field_of_view);
    if (is_tilted(camera, scene_up)) {
        append(numbers, camera.up);
    }
    return "--camera " + numbers;
}

} // namespace raysteps
