#include "reference/direction_error.h"

#include "reference/reference_ray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace raysteps {

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
