#include "parse/parse_camera.h"

#include "error/error.h"
#include "parse/words.h"

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

} // namespace raysteps
