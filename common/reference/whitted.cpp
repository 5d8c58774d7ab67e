#include "reference/whitted.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "reference/brute_force.h"
#include "reference/reference_ray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

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

namespace {

// A recursion this deep fits every stack, and no picture needs more.
constexpr int deepest_recursion = 1000;

void check_arguments(int width, int height, int max_bounces) {
    if (width < 1 || height < 1) {
        throw InputError("picture of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels: it has none. Make both at least 1.");
    }
    if (max_bounces < 0 || max_bounces > deepest_recursion) {
        throw InputError("max_bounces is " + std::to_string(max_bounces) + ". Use 0 to " +
                         std::to_string(deepest_recursion) + ".");
    }
}

// The light counts as reached just before its position, so a surface that it lies on casts no
// shadow.
constexpr double before_the_light = 1.0 - 1.0 / 65536.0; // 1 - 2^-16

bool is_lit(const Scene& scene, const Surface& surface, const glm::dvec3& light) {
    const glm::dvec3 to_light = light - surface.point;
    if (glm::dot(surface.shading_normal, to_light) <= 0.0 ||
        glm::dot(surface.geometric_normal, to_light) <= 0.0) {
        return false;
    }
    const ReferenceRay shadow_ray{.origin = surface.point_above,
                                  .direction = light - surface.point_above,
                                  .t_max = before_the_light};
    return !any_hit(shadow_ray, scene.corners);
}

// Lambert's law, as the paper has it: N.L, the colour of the surface and that of the light.
glm::dvec3 diffuse_light(const Scene& scene, const Surface& surface) {
    glm::dvec3 color(0.0);
    for (const Light& light : scene.lights) {
        const glm::dvec3 position(light.position);
        if (is_lit(scene, surface, position)) {
            const glm::dvec3 to_light = glm::normalize(position - surface.point);
            color += glm::dvec3(surface.material->diffuse) * glm::dvec3(light.color) *
                     glm::dot(surface.shading_normal, to_light);
        }
    }
    return color;
}

glm::dvec3 mirror_direction(const Surface& surface, const glm::dvec3& direction) {
    const auto reflect_about = [&](const glm::dvec3& normal) {
        return direction - 2.0 * glm::dot(normal, direction) * normal;
    };
    const glm::dvec3 reflected = reflect_about(surface.shading_normal);
    if (glm::dot(reflected, surface.geometric_normal) > 0.0) {
        return reflected;
    }
    return reflect_about(surface.geometric_normal); // the other one would enter the surface
}

// The colour that comes back along the ray.
glm::dvec3 trace(const Scene& scene, const ReferenceRay& ray, int bounces_left) {
    const ReferenceHit hit = nearest_hit(ray, scene.corners);
    if (hit.triangle == no_triangle) {
        return scene.background;
    }
    const Surface surface = surface_at(scene, ray, hit);
    const glm::dvec3 color = glm::dvec3(surface.material->emission) + diffuse_light(scene, surface);
    if (!is_mirror(*surface.material) || bounces_left == 0) {
        return color;
    }
    const ReferenceRay reflected{.origin = surface.point_above,
                                 .direction = mirror_direction(surface, ray.direction)};
    return color +
           glm::dvec3(surface.material->specular) * trace(scene, reflected, bounces_left - 1);
}

struct Pixel {
    int column = 0;
    int row = 0;
};

Pixel pixel_at(std::size_t i, int width) {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(i % columns), static_cast<int>(i / columns)};
}

} // namespace

Image render_whitted(const Scene& scene, int width, int height, int max_bounces) {
    check_arguments(width, height, max_bounces);
    Image image(width, height);
    on_threads(all_cores, image.pixels.size(), [&](std::size_t i) {
        const auto [column, row] = pixel_at(i, width);
        const ReferenceRay ray = reference_ray(scene.camera, width, height, column, row);
        image.at(column, row) = trace(scene, ray, max_bounces);
    });
    return image;
}

std::vector<double> whitted_sensitivity(const Scene& scene, int width, int height, int max_bounces,
                                        double shift) {
    check_arguments(width, height, max_bounces);
    std::vector<double> sensitivity(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
    on_threads(all_cores, sensitivity.size(), [&](std::size_t i) {
        const Pixel pixel = pixel_at(i, width);
        const auto color_beside = [&](double right, double down) {
            const ReferenceRay ray =
                reference_ray(scene.camera, width, height, pixel.column + right, pixel.row + down);
            return trace(scene, ray, max_bounces);
        };
        const glm::dvec3 middle = color_beside(0.0, 0.0);
        for (const glm::dvec3& color : {color_beside(-shift, 0.0), color_beside(shift, 0.0),
                                        color_beside(0.0, -shift), color_beside(0.0, shift)}) {
            const glm::dvec3 change = glm::abs(color - middle);
            sensitivity[i] = std::max({sensitivity[i], change.x, change.y, change.z});
        }
    });
    return sensitivity;
}

} // namespace raysteps
