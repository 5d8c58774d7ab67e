#include "scene/camera_text.h"

#include "basics/error.h"
#include "basics/text.h"
#include "scene/scaling.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

// Of a text whose words are numbers.
std::vector<double> doubles_of(const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& word : split_words(text, ',')) {
        numbers.push_back(parse_number<double>(word).value_or(0.0));
    }
    return numbers;
}

} // namespace

Camera parse_camera(const std::string& text, const Camera& start, const glm::dvec3& origin) {
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
    if (origin != glm::dvec3(0.0)) { // beside which a float would have too few digits
        const std::vector<double> places = doubles_of(text);
        camera.eye = as_seen_from(origin, {places[0], places[1], places[2]});
        camera.target = as_seen_from(origin, {places[3], places[4], places[5]});
    }
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

void append_place(std::string& text, const glm::vec3& place, const glm::dvec3& origin) {
    if (origin == glm::dvec3(0.0)) {
        append(text, place);
        return;
    }
    const glm::dvec3 in_file = glm::dvec3(place) + origin;
    for (int axis = 0; axis < 3; ++axis) {
        text += fmt::format("{}{}", text.empty() ? "" : ",", in_file[axis]);
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

std::string camera_text(const Camera& camera, const glm::vec3& scene_up, const glm::dvec3& origin) {
    std::string numbers;
    append_place(numbers, camera.eye, origin);
    append_place(numbers, camera.target, origin);
    numbers += "," + shortest_text(camera.vertical_field_of_view);
    if (is_tilted(camera, scene_up)) {
        append(numbers, camera.up);
    }
    return "--camera " + numbers;
}

} // namespace raysteps
