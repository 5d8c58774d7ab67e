#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// Looks from eye to target. The angle is the vertical field of view, in degrees, over 0 and under
// 180; eye and target differ, and up is not parallel to the line between them.
struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 5.0f};
    glm::vec3 target{0.0f, 0.0f, 0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float vertical_field_of_view = 40.0f;
    float aperture = 0.0f;       // of the lens, its diameter; 0 is a pinhole, which is all sharp
    float focus_distance = 0.0f; // of the sharp plane from the eye; 0 is the target's
    int samples = 0;             // rays a pixel; 0 is as many as the scene calls for
};

} // namespace raysteps
