#pragma once

#include "image/image.h"
#include "mirror/mirror_scene.h"

#include <vector>

namespace raysteps::mirror {

// The colour along one path: what the passes of the wavefront do to one pixel, in their order.
template <class Mirror>
typename Mirror::real3 color_along(Mirror& mirror, typename Mirror::Ray ray, const Scene& scene,
                                   int max_bounces) {
    using Real3 = typename Mirror::real3;
    Real3 color(0);
    Real3 weight(1);
    for (int bounce = 0;; ++bounce) {
        const auto hit = mirror.closest_hit(ray);
        if (!mirror.is_hit(hit)) {
            return color + weight * Real3(scene.background);
        }
        const auto surface = mirror.surface_at(ray, hit);
        color += weight * surface.material.emission;
        for (const Light& light : scene.lights) {
            const Real3 position(light.position);
            const auto shadow_ray = mirror.shadow_ray(surface, position);
            if (mirror.is_empty(shadow_ray) || mirror.is_hit(mirror.any_hit(shadow_ray))) {
                continue;
            }
            color += weight * mirror.diffuse_light(surface, position, Real3(light.color));
        }
        if (!surface.material.mirror || bounce == max_bounces) {
            return color;
        }
        weight *= surface.material.specular;
        ray = mirror.mirror_ray(surface, ray);
    }
}

// The picture that the wavefront makes, computed here by the same shader parts.
template <class Mirror>
Image render_whitted_by_mirror(Mirror& mirror, const Scene& scene, const View& view, int width,
                               int height, int max_bounces) {
    using Real = typename Mirror::real;
    const auto mirror_view = to_mirror<Mirror>(view);
    Image image(width, height);
    for (int row = 0; row < height; ++row) {
        const Real t =
            (static_cast<Real>(height - 1 - row) + Real(0.5)) / static_cast<Real>(height);
        for (int column = 0; column < width; ++column) {
            const Real s = (static_cast<Real>(column) + Real(0.5)) / static_cast<Real>(width);
            image.at(column, row) = glm::vec3(
                color_along(mirror, mirror.primary_ray(mirror_view, s, t), scene, max_bounces));
        }
    }
    return image;
}

} // namespace raysteps::mirror
