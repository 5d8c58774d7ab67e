#include "reference/optics.h"

#include "reference/brute_force.h"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raysteps {

double fresnel_by_angle(double angle, double index_before, double index_behind) {
    if (index_before == index_behind) {
        return 0.0;
    }
    const double sine_behind = std::sin(angle) * index_before / index_behind;
    if (sine_behind >= 1.0) {
        return 1.0;
    }
    const double behind = std::asin(sine_behind);
    if (angle < 1e-6) { // 0 / 0 there: the limit
        const double ratio = (index_before - index_behind) / (index_before + index_behind);
        return ratio * ratio;
    }
    const double across = std::sin(angle - behind) / std::sin(angle + behind);
    const double along = std::tan(angle - behind) / std::tan(angle + behind);
    return 0.5 * (across * across + along * along);
}

namespace optics {

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
    const glm::dvec3 normal = mix_corners(scene.normals, hit);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    // The corners of a triangle that closes a slit may lie on one line: it has no plane.
    surface.geometric_normal = glm::normalize(area == glm::dvec3(0.0) ? normal : area);
    if (glm::dot(surface.geometric_normal, ray.direction) > 0.0) {
        surface.geometric_normal = -surface.geometric_normal;
    }
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

double clear_part(const Material& material) {
    if (material.opacity < 1.0f) {
        return 1.0 - static_cast<double>(material.opacity);
    }
    switch (material.illumination_model) {
    case 4:
    case 6:
    case 7:
    case 9:
        return 1.0;
    default:
        return 0.0;
    }
}

Passage passage(const Bodies& inside, const Material* material, bool outside) {
    Passage passage{inside, inside};
    if (outside) {
        passage.behind.push_back(material);
        return passage;
    }
    Bodies& behind = passage.behind;
    const auto innermost = std::find(behind.rbegin(), behind.rend(), material);
    if (innermost == behind.rend()) {
        passage.before.push_back(material); // it was in there from the start
        return passage;
    }
    behind.erase(std::next(innermost).base());
    return passage;
}

double index_of(const Bodies& bodies) {
    return bodies.empty() ? 1.0 : static_cast<double>(bodies.back()->refractive_index);
}

glm::dvec3 left_after(const Material& material, double distance) {
    return glm::pow(glm::dvec3(material.transmission), glm::dvec3(distance));
}

glm::dvec3 sky_seen(const Scene& scene, const glm::dvec3& direction) {
    if (!scene.sky) {
        return scene.background;
    }
    const double height = glm::normalize(direction).y;
    const glm::dvec3 horizon(scene.sky->horizon);
    if (height > 0.0) {
        return glm::mix(horizon, glm::dvec3(scene.sky->zenith), height);
    }
    return glm::mix(horizon, glm::dvec3(scene.sky->ground), std::min(1.0, -4.0 * height));
}

bool is_outer_side(const Scene& scene, const ReferenceRay& ray, const ReferenceHit& hit) {
    const std::size_t first = 3 * static_cast<std::size_t>(hit.triangle);
    const glm::dvec3 a(scene.corners[first]);
    const glm::dvec3 b(scene.corners[first + 1]);
    const glm::dvec3 c(scene.corners[first + 2]);
    return glm::dot(glm::cross(b - a, c - a), ray.direction) <= 0.0;
}

glm::dvec3 point_behind(const Surface& surface) {
    return surface.point - (surface.point_above - surface.point);
}

glm::dvec3 mirror_direction(const Surface& surface, const glm::dvec3& direction) {
    const auto reflect_about = [&](const glm::dvec3& normal) {
        return direction - 2.0 * glm::dot(normal, direction) * normal;
    };
    const glm::dvec3 reflected = reflect_about(surface.shading_normal);
    return glm::dot(reflected, surface.geometric_normal) > 0.0
               ? reflected
               : reflect_about(surface.geometric_normal); // the other one would enter the surface
}

namespace {

// By Snell's law, built from the angle: along the normal and across it.
glm::dvec3 bent(const glm::dvec3& direction, const glm::dvec3& normal, double ratio) {
    const double angle = std::acos(std::clamp(-glm::dot(direction, normal), 0.0, 1.0));
    const double behind = std::asin(std::min(1.0, ratio * std::sin(angle)));
    const glm::dvec3 aside = direction + normal * std::cos(angle);
    const double length = glm::length(aside);
    return length > 0.0 ? std::sin(behind) / length * aside - std::cos(behind) * normal : -normal;
}

} // namespace

GlassWays ways_at_glass(const ReferenceRay& ray, const Surface& surface, const Bodies& inside,
                        bool outside) {
    const Passage way = passage(inside, surface.material, outside);
    const double before = index_of(way.before);
    const double behind = index_of(way.behind);
    const glm::dvec3 direction = glm::normalize(ray.direction);
    const bool turned = glm::dot(direction, surface.shading_normal) >= 0.0;
    const glm::dvec3 normal = turned ? surface.geometric_normal : surface.shading_normal;
    const double angle = std::acos(std::clamp(-glm::dot(direction, normal), 0.0, 1.0));

    GlassWays ways;
    ways.bodies = way;
    ways.reflected_part = fresnel_by_angle(angle, before, behind);
    ways.reflected = {.origin = surface.point_above,
                      .direction = mirror_direction(surface, ray.direction)};
    if (ways.reflected_part < 1.0) {
        glm::dvec3 on = before == behind ? direction : bent(direction, normal, before / behind);
        on = glm::dot(on, surface.geometric_normal) >= 0.0 ? direction : on;
        ways.refracted = {.origin = point_behind(surface), .direction = on};
    }
    return ways;
}

} // namespace optics

} // namespace raysteps
