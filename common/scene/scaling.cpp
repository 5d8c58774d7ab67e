#include "scene/scaling.h"

#include "basics/box.h"
#include "basics/error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

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

namespace {

constexpr double farthest_sides = 16.0; // from the origin, of the largest side
constexpr double float_digits = 24.0;
constexpr double digits_enough = 10.0; // a thousand steps along the smallest edge

double greatest_of(const glm::dvec3& vector) {
    const glm::dvec3 sizes = glm::abs(vector);
    return std::max({sizes.x, sizes.y, sizes.z});
}

double smallest_edge_of(const Scene& scene) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec3 edge = glm::dvec3(scene.corners[next]) - glm::dvec3(scene.corners[i]);
        const double squared = glm::dot(edge, edge);
        smallest = squared > 0.0 ? std::min(smallest, squared) : smallest;
    }
    return std::sqrt(smallest);
}

std::string point_text(const glm::dvec3& point) {
    return fmt::format("{},{},{}", point.x, point.y, point.z);
}

} // namespace

glm::dvec3 offset_of(const DoubleBox& box) {
    const glm::dvec3 middle = 0.5 * box.lower + 0.5 * box.upper;
    const double side = greatest_of(box.upper - box.lower);
    const double farthest = std::max(greatest_of(box.lower), greatest_of(box.upper));
    if (!(side > 0.0) || !std::isfinite(side) || farthest <= farthest_sides * side) {
        return glm::dvec3(0.0);
    }
    const double unit = std::exp2(std::floor(std::log2(side)) - 2.0);
    return unit * glm::round(middle / unit) + glm::dvec3(0.0); // -0 becomes 0
}

glm::vec3 as_seen_from(const glm::dvec3& origin, const glm::dvec3& point) {
    const glm::vec3 seen(point - origin);
    return origin == glm::dvec3(0.0) ? seen : glm::vec3((glm::dvec3(seen) + origin) - origin);
}

Camera moved(Camera camera, const glm::dvec3& offset) {
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + offset);
    camera.target = glm::vec3(glm::dvec3(camera.target) + offset);
    return camera;
}

std::vector<std::string> tell_precision(const Scene& scene) {
    std::vector<std::string> sentences;
    if (scene.origin != glm::dvec3(0.0)) {
        sentences.push_back(fmt::format(
            "{}: it lies so far from the origin that floats would leave steps of {:.2g}, so {} was "
            "taken from all its coordinates. --camera, --rays and --print-scene take and give "
            "those of the file; --tree and the program check count from there.",
            scene.name, std::exp2(std::floor(std::log2(greatest_of(scene.origin))) - 23.0),
            point_text(scene.origin)));
    }
    const Box box = bounds_of(scene.corners);
    const double edge = smallest_edge_of(scene);
    if (is_empty(box) || !std::isfinite(edge)) {
        return sentences;
    }
    const double farthest = std::max(greatest_of(box.lower), greatest_of(box.upper));
    const double digits = float_digits + std::log2(edge / farthest);
    if (digits < digits_enough) {
        sentences.push_back(
            fmt::format("{}: beside its largest coordinate, {:.3g}, a float has {:.1f} bits left "
                        "for the smallest edge, {:.3g}.",
                        scene.name, farthest, std::max(digits, 0.0), edge));
    }
    return sentences;
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
