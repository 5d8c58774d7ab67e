#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// A pinhole that looks from eye to target. The angle is the vertical field of view, in degrees,
// over 0 and under 180; eye and target differ, and up is not parallel to the line between them.
struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 5.0f};
    glm::vec3 target{0.0f, 0.0f, 0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float vertical_field_of_view = 40.0f;
};

} // namespace raysteps
