#include "reference/whitted.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "reference/brute_force.h"
#include "reference/reference_ray.h"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

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

namespace {

// What the shading needs of a point where a ray met the scene. Both normals have length 1 and lie
// on the side that the ray came from.
struct Surface {
    glm::dvec3 point{0.0};
    glm::dvec3 geometric_normal{0.0};
    glm::dvec3 shading_normal{0.0}; // the corners' normals, mixed; the geometric one if they cancel
    glm::dvec3 point_above{0.0};    // the point moved just off the surface: where rays leave it
    const Material* material = nullptr;
};

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

// The hit must be of a triangle of the scene, by this ray.
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

// The part of the light that a material lets through, as its MTL statements d and illum say.
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

// Materials of the bodies that a ray is inside of, the innermost last.
using Bodies = std::vector<const Material*>;

// What a ray passes from and to at a surface.
struct Passage {
    Bodies before;
    Bodies behind;
};

// At a surface of that material; `outside` where the ray meets its outer side.
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

// Of air, 1, where the ray is inside of nothing.
double index_of(const Bodies& bodies) {
    return bodies.empty() ? 1.0 : static_cast<double>(bodies.back()->refractive_index);
}

// What absorption leaves after so much of a way (Beer's law).
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

glm::dvec3 mirror_direction(const Surface& surface, const glm::dvec3& direction) {
    const auto reflect_about = [&](const glm::dvec3& normal) {
        return direction - 2.0 * glm::dot(normal, direction) * normal;
    };
    const glm::dvec3 reflected = reflect_about(surface.shading_normal);
    return glm::dot(reflected, surface.geometric_normal) > 0.0
               ? reflected
               : reflect_about(surface.geometric_normal); // the other one would enter the surface
}

// By Snell's law, built from the angle: along the normal and across it.
glm::dvec3 bent(const glm::dvec3& direction, const glm::dvec3& normal, double ratio) {
    const double angle = std::acos(std::clamp(-glm::dot(direction, normal), 0.0, 1.0));
    const double behind = std::asin(std::min(1.0, ratio * std::sin(angle)));
    const glm::dvec3 aside = direction + normal * std::cos(angle);
    const double length = glm::length(aside);
    return length > 0.0 ? std::sin(behind) / length * aside - std::cos(behind) * normal : -normal;
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
        const Passage way = passage(inside, surface.material, outside);
        const double before = index_of(way.before);
        const double behind = index_of(way.behind);
        const glm::dvec3 direction = glm::normalize(ray.direction);
        const bool turned = glm::dot(direction, surface.shading_normal) >= 0.0;
        const glm::dvec3 normal = turned ? surface.geometric_normal : surface.shading_normal;
        const double angle = std::acos(std::clamp(-glm::dot(direction, normal), 0.0, 1.0));
        const double reflected_part = fresnel_by_angle(angle, before, behind);
        const double clear = clear_part(*surface.material);

        const ReferenceRay reflected{.origin = surface.point_above,
                                     .direction = mirror_direction(surface, ray.direction)};
        glm::dvec3 color =
            send(reflected, glm::dvec3(clear * reflected_part), weight, way.before, bounces_left);
        if (reflected_part < 1.0) {
            glm::dvec3 on = before == behind ? direction : bent(direction, normal, before / behind);
            on = glm::dot(on, surface.geometric_normal) >= 0.0 ? direction : on;
            color +=
                send({.origin = point_behind(surface), .direction = on},
                     glm::dvec3(clear * (1.0 - reflected_part)), weight, way.behind, bounces_left);
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
