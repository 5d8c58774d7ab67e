#include "reference/surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace raysteps {

namespace {

glm::dvec3 mix_corners(const std::vector<glm::vec3>& values, const ReferenceHit& hit) {
    const std::size_t first = 3 * static_cast<std::size_t>(hit.triangle);
    return (1.0 - hit.u - hit.v) * glm::dvec3(values[first]) +
           hit.u * glm::dvec3(values[first + 1]) + hit.v * glm::dvec3(values[first + 2]);
}

double largest_coordinate(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
    return std::max({largest.x, largest.y, largest.z});
}

// The mixed point's coordinates are wrong by at most 8 roundings of the largest coordinate, that is
// 2^-50 of it: three weights, three products, two sums. A ray that leaves the point finds its own
// triangle's plane with an error of the same size. 2^-40 is a thousand times that, which leaves
// room for slivers and grazing rays, and is far under the spacing of floats, 2^-24, so it skips
// nothing that a scene in float can tell from the surface.
constexpr double offset_factor = 1.0 / 1099511627776.0; // 2^-40

} // namespace

Surface surface_at(const Scene& scene, const ReferenceRay& ray, const ReferenceHit& hit) {
    const auto triangle = static_cast<std::size_t>(hit.triangle);
    const glm::dvec3 a(scene.corners[3 * triangle]);
    const glm::dvec3 b(scene.corners[3 * triangle + 1]);
    const glm::dvec3 c(scene.corners[3 * triangle + 2]);
    Surface surface;
    surface.point = mix_corners(scene.corners, hit);
    surface.geometric_normal = glm::normalize(glm::cross(b - a, c - a));
    if (glm::dot(surface.geometric_normal, ray.direction) > 0.0) {
        surface.geometric_normal = -surface.geometric_normal;
    }
    const glm::dvec3 normal = mix_corners(scene.normals, hit);
    surface.shading_normal =
        normal == glm::dvec3(0.0) ? surface.geometric_normal : glm::normalize(normal);
    if (glm::dot(surface.shading_normal, surface.geometric_normal) < 0.0) {
        surface.shading_normal = -surface.shading_normal;
    }
    surface.point_above =
        surface.point + surface.geometric_normal * (offset_factor * largest_coordinate(a, b, c));
    const auto material = static_cast<std::size_t>(scene.triangle_materials[triangle]);
    surface.material = &scene.materials[material];
    return surface;
}

} // namespace raysteps
