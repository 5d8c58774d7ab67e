#include "scene/view.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <limits>

namespace raysteps {

View view_of(const Camera& camera, double aspect_ratio) {
    const glm::dvec3 eye(camera.eye);
    const auto [right, up, forward] =
        view_frame(glm::dvec3(camera.target) - eye, glm::dvec3(camera.up));
    const double half_height =
        std::tan(glm::radians(static_cast<double>(camera.vertical_field_of_view)) / 2.0);
    const double half_width = half_height * aspect_ratio;

    View view{};
    view.eye = camera.eye;
    view.lower_left = glm::vec3(forward - half_width * right - half_height * up);
    view.right = glm::vec3(2.0 * half_width * right);
    view.up = glm::vec3(2.0 * half_height * up);
    return view;
}

// A point of the lens is at most its radius from the eye. shaders/light/lens.glsl rounds a sine or
// cosine, a unit vector and a few products of that size, and one sum: 2^-22 of both covers them.
Box origins_of(const Camera& camera) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float radius = 0.5f * camera.aperture;
    Box origins{camera.eye, camera.eye};
    for (int axis = 0; axis < 3 && radius > 0.0f; ++axis) {
        const float step = 0x1p-22f * (std::abs(camera.eye[axis]) + radius);
        origins.lower[axis] = std::nextafter(camera.eye[axis] - radius - step, -infinity);
        origins.upper[axis] = std::nextafter(camera.eye[axis] + radius + step, infinity);
    }
    return origins;
}

} // namespace raysteps
