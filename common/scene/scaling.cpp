#include "scene/scaling.h"

#include "basics/box.h"
#include "basics/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

// Products under 2^-76 (least_product in shaders/real/float.glsl) count as they are rounded. Where
// every length is under 2^-38, that holds for each product of two of them.
constexpr double smallest_size = 0x1p-38;

glm::vec3 scaled(const glm::vec3& length, int exponent) {
    return {std::ldexp(length.x, exponent), std::ldexp(length.y, exponent),
            std::ldexp(length.z, exponent)};
}

bool is_finite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

} // namespace

Camera scaled(Camera camera, int exponent) {
    camera.eye = scaled(camera.eye, exponent);
    camera.target = scaled(camera.target, exponent);
    camera.aperture = std::ldexp(camera.aperture, exponent);
    camera.focus_distance = std::ldexp(camera.focus_distance, exponent);
    return camera;
}

Light scaled(Light light, int exponent) {
    light.position = scaled(light.position, exponent);
    light.across = scaled(light.across, exponent);
    light.along = scaled(light.along, exponent);
    return light;
}

Material scaled(Material material, int exponent) {
    for (int i = 0; i < 3; ++i) {
        material.transmission[i] = static_cast<float>(
            std::pow(static_cast<double>(material.transmission[i]), std::ldexp(1.0, -exponent)));
    }
    return material;
}

Ray scaled(const Ray& ray, int exponent) {
    const Ray result{scaled(ray.origin, exponent), scaled(ray.direction, exponent), ray.t_min,
                     ray.t_max};
    if (is_finite(ray.origin) && is_finite(ray.direction) &&
        !(is_finite(result.origin) && is_finite(result.direction))) {
        throw InputError(fmt::format("--scale-exponent {}: a ray's numbers are too large for a "
                                     "float then. Take a smaller exponent.",
                                     exponent));
    }
    return result;
}

std::string warn_of_size(const Scene& scene) {
    const Box box = bounds_of(scene.corners);
    if (is_empty(box)) {
        return "";
    }
    const glm::dvec3 sides = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    const double side = std::max({sides.x, sides.y, sides.z});
    if (side >= smallest_size || side == 0.0) {
        return "";
    }
    return fmt::format(
        "{}: its largest side is {:.2g}, and products of such lengths lose their last digits. "
        "Below "
        "1e-16 structures find other hits than the loop over every triangle, and below 1e-19 rays "
        "pass through closed meshes. Add --scale-exponent {}: every length is then multiplied by a "
        "power of two, and the hits of --rays stay as they are.",
        scene.name, side, std::min(-std::ilogb(side), greatest_scale_exponent));
}

} // namespace raysteps
