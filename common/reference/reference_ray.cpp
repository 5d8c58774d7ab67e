#include "reference/reference_ray.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace raysteps {

ReferenceRay reference_ray(const Ray& ray) {
    return {glm::dvec3(ray.origin), glm::dvec3(ray.direction), ray.t_min, ray.t_max};
}

ReferenceRay reference_ray(const Camera& camera, int width, int height, double column, double row) {
    const glm::dvec3 eye(camera.eye);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    const glm::dvec3 true_up = glm::cross(right, forward);
    const double half_height = std::tan(glm::radians(double{camera.vertical_field_of_view}) / 2.0);
    const double half_width = half_height * width / height;
    const double from_middle = 2.0 * (column + 0.5) / width - 1.0; // -1 left, +1 right
    const double above_middle = 1.0 - 2.0 * (row + 0.5) / height;  // -1 bottom, +1 top
    return {.origin = eye,
            .direction = forward + right * (half_width * from_middle) +
                         true_up * (half_height * above_middle)};
}

} // namespace raysteps
