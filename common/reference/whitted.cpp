#include "reference/whitted.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "reference/brute_force.h"
#include "reference/optics.h"
#include "reference/reference_ray.h"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace raysteps {

using namespace optics;

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

// What is left of the light's way to the surface: nothing behind an opaque thing.
glm::dvec3 light_that_comes(const Scene& scene, const Surface& surface, const glm::dvec3& light) {
    glm::dvec3 left(1.0);
    glm::dvec3 origin = surface.point_above;
    for (int i = 0; i < 64; ++i) {
        const ReferenceRay ray{
            .origin = origin, .direction = light - origin, .t_max = before_the_light};
        const ReferenceHit hit = nearest_hit(ray, scene.corners);
        if (hit.triangle == no_triangle) {
            return left;
        }
        const Surface met = surface_at(scene, ray, hit);
        const double clear = clear_part(*met.material);
        if (clear == 0.0) {
            return glm::dvec3(0.0);
        }
        const double cosine = -glm::dot(glm::normalize(ray.direction), met.geometric_normal);
        left *=
            clear * (1.0 - fresnel_by_angle(std::acos(std::min(cosine, 1.0)), 1.0,
                                            static_cast<double>(met.material->refractive_index)));
        if (!is_outer_side(scene, ray, hit)) {
            left *= left_after(*met.material, hit.t * glm::length(ray.direction));
        }
        origin = point_behind(met);
    }
    return glm::dvec3(0.0);
}

glm::dvec3 lamp_light(const Scene& scene, const Surface& surface, const glm::dvec3& direction) {
    const Material& material = *surface.material;
    glm::dvec3 color(0.0);
    for (const Light& light : scene.lights) {
        const glm::dvec3 to_light = glm::dvec3(light.position) - surface.point;
        if (glm::dot(surface.shading_normal, to_light) <= 0.0 ||
            glm::dot(surface.geometric_normal, to_light) <= 0.0) {
            continue;
        }
        const glm::dvec3 coming =
            glm::dvec3(light.color) * light_that_comes(scene, surface, glm::dvec3(light.position));
        const glm::dvec3 to = glm::normalize(to_light);
        const glm::dvec3 diffuse = (1.0 - clear_part(material)) * glm::dvec3(material.diffuse);
        color += coming * diffuse * glm::dot(surface.shading_normal, to);
        if (material.illumination_model >= 2 && material.shininess > 0.0f) {
            const glm::dvec3 halfway = glm::normalize(to - glm::normalize(direction));
            const double cosine = std::max(0.0, glm::dot(surface.shading_normal, halfway));
            color += coming * glm::dvec3(material.specular) *
                     std::pow(cosine, static_cast<double>(material.shininess));
        }
    }
    return color;
}

class Tree {
public:
    Tree(const Scene& scene, const TreeLimits& limits) : scene_(scene), limits_(limits) {}

    // The colour that comes back along the ray. The weight is what the ray counts for its pixel.
    glm::dvec3 trace(const ReferenceRay& ray, const glm::dvec3& weight, const Bodies& inside,
                     int bounces_left) const {
        const ReferenceHit hit = nearest_hit(ray, scene_.corners);
        if (hit.triangle == no_triangle) {
            return sky_seen(scene_, ray.direction);
        }
        const glm::dvec3 kept =
            inside.empty() ? glm::dvec3(1.0)
                           : left_after(*inside.back(), hit.t * glm::length(ray.direction));
        const Surface surface = surface_at(scene_, ray, hit);
        glm::dvec3 color =
            glm::dvec3(surface.material->emission) + lamp_light(scene_, surface, ray.direction);
        if (bounces_left > 0 && clear_part(*surface.material) > 0.0) {
            const bool outside = is_outer_side(scene_, ray, hit);
            color += glass_light(ray, surface, weight * kept, inside, outside, bounces_left - 1);
        } else if (bounces_left > 0 && is_mirror(*surface.material)) {
            const ReferenceRay reflected{.origin = surface.point_above,
                                         .direction = mirror_direction(surface, ray.direction)};
            color += send(reflected, glm::dvec3(surface.material->specular), weight * kept, inside,
                          bounces_left - 1);
        }
        return kept * color;
    }

private:
    glm::dvec3 send(const ReferenceRay& ray, const glm::dvec3& part, const glm::dvec3& weight,
                    const Bodies& inside, int bounces_left) const {
        const glm::dvec3 counts = weight * part;
        if (std::max({counts.x, counts.y, counts.z}) <= limits_.faintest) {
            return glm::dvec3(0.0);
        }
        return part * trace(ray, counts, inside, bounces_left);
    }

    glm::dvec3 glass_light(const ReferenceRay& ray, const Surface& surface,
                           const glm::dvec3& weight, const Bodies& inside, bool outside,
                           int bounces_left) const {
        const GlassWays ways = ways_at_glass(ray, surface, inside, outside);
        const double clear = clear_part(*surface.material);
        glm::dvec3 color = send(ways.reflected, glm::dvec3(clear * ways.reflected_part), weight,
                                ways.bodies.before, bounces_left);
        if (ways.reflected_part < 1.0) {
            color += send(ways.refracted, glm::dvec3(clear * (1.0 - ways.reflected_part)), weight,
                          ways.bodies.behind, bounces_left);
        }
        return color;
    }

    const Scene& scene_;
    TreeLimits limits_;
};

glm::dvec3 color_at(const Scene& scene, int width, int height, const TreeLimits& limits,
                    double column, double row) {
    return Tree(scene, limits)
        .trace(reference_ray(scene.camera, width, height, column, row), glm::dvec3(1.0), {},
               limits.max_bounces);
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

Image render_whitted(const Scene& scene, int width, int height, const TreeLimits& limits) {
    check_arguments(width, height, limits.max_bounces);
    Image image(width, height);
    on_threads(all_cores, image.pixels.size(), [&](std::size_t i) {
        const auto [column, row] = pixel_at(i, width);
        image.pixels[i] = color_at(scene, width, height, limits, column, row);
    });
    return image;
}

std::vector<double> whitted_sensitivity(const Scene& scene, int width, int height,
                                        const TreeLimits& limits, double shift) {
    check_arguments(width, height, limits.max_bounces);
    std::vector<double> sensitivity(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
    on_threads(all_cores, sensitivity.size(), [&](std::size_t i) {
        const Pixel pixel = pixel_at(i, width);
        const auto color_beside = [&](double right, double down) {
            return color_at(scene, width, height, limits, pixel.column + right, pixel.row + down);
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

Scene without_optics(Scene scene) {
    scene.sky.reset();
    for (Material& material : scene.materials) {
        constexpr int plain_mirror = 3;
        constexpr int plain_surface = 1;
        material.illumination_model = is_mirror(material) ? plain_mirror : plain_surface;
        material.shininess = 0.0f; // no highlights
        material.opacity = 1.0f;
    }
    return scene;
}

} // namespace raysteps
