#include "reference/reference_ray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
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

namespace {

double largest_component(const glm::dvec3& vector) {
    return std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
}

// The distance from the magnitude of a number to the next float.
double ulp(double number) {
    return std::ldexp(1.0, std::ilogb(number) - 23);
}

} // namespace

std::vector<float> direction_errors(std::span<const Ray> rays, const Camera& camera, int width,
                                    int height) {
    std::vector<float> errors;
    errors.reserve(rays.size());
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const glm::dvec3 exact = reference_ray(camera, width, height, column, row).direction;
            const std::size_t place =
                static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column);
            const glm::dvec3 difference = glm::dvec3(rays[place].direction) - exact;
            errors.push_back(
                static_cast<float>(largest_component(difference) / ulp(largest_component(exact))));
        }
    }
    return errors;
}

} // namespace raysteps
