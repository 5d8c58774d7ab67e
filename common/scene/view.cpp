#include "scene/view.h"

#include <glm/trigonometric.hpp>

#include <cmath>

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

} // namespace raysteps
