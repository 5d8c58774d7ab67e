#pragma once

#include "basics/box.h"
#include "basics/ray.h"
#include "scene/scene.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raysteps {

// The rectangle that the camera looks through at this aspect ratio (width / height), computed in
// double and rounded once.
View view_of(const Camera& camera, double aspect_ratio);

// A box around all points at which the camera's rays start: its eye, or the whole of its lens.
Box origins_of(const Camera& camera);

// Three perpendicular directions of length 1, as seen by who looks forward.
struct ViewFrame {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
};

// The line of sight is not 0, and up is not parallel to it.
inline ViewFrame view_frame(const glm::dvec3& line_of_sight, const glm::dvec3& up) {
    const glm::dvec3 forward = glm::normalize(line_of_sight);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::normalize(up)));
    return {right, glm::cross(right, forward), forward};
}

} // namespace raysteps
