#include "reference/reference_paths.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "reference/brute_force.h"
#include "reference/optics.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace raysteps {

using namespace optics;

namespace {

constexpr double before_the_lamp =
    1.0 - 1.0 / 65536.0; // 1 - 2^-16: the lamp stops no ray to itself

// The C++ standard fixes what this generator gives, on every machine.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : generator_(seed) {}

    // In [0, 1).
    double number() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }

    // On the ball of radius 1: a point of the cube that lies in the ball, pushed out.
    glm::dvec3 direction() {
        for (;;) {
            const double x = 2.0 * number() - 1.0;
            const double y = 2.0 * number() - 1.0;
            const glm::dvec3 point{x, y, 2.0 * number() - 1.0};
            const double squared = glm::dot(point, point);
            if (squared <= 1.0 && squared > 1e-12) {
                return point / std::sqrt(squared);
            }
        }
    }

private:
    std::mt19937_64 generator_;
};

struct GlowingTriangle {
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 c;
    glm::dvec3 emission;
    double area_up_to_here = 0.0;
};

std::vector<GlowingTriangle> what_glows(const Scene& scene) {
    std::vector<GlowingTriangle> glowing;
    double area = 0.0;
    for (int i = 0; i < triangle_count(scene); ++i) {
        const auto first = 3 * static_cast<std::size_t>(i);
        const Material& material = scene.materials[static_cast<std::size_t>(
            scene.triangle_materials[static_cast<std::size_t>(i)])];
        const glm::dvec3 a(scene.corners[first]);
        const glm::dvec3 b(scene.corners[first + 1]);
        const glm::dvec3 c(scene.corners[first + 2]);
        const double own = 0.5 * glm::length(glm::cross(b - a, c - a));
        if (material.emission != glm::vec3(0.0f) && own > 0.0) {
            area += own;
            glowing.push_back({a, b, c, glm::dvec3(material.emission), area});
        }
    }
    return glowing;
}

class Recursion {
public:
    explicit Recursion(const Scene& scene) : scene_(scene), glowing_(what_glows(scene)) {}

    // The radiance that comes back along the ray. `sees_lamps` where no other ray looked for them.
    glm::dvec3 radiance(const ReferenceRay& ray, const Bodies& inside, int bounces_left,
                        bool sees_lamps, Chance& chance) const {
        const ReferenceHit hit = nearest_hit(ray, scene_.corners);
        if (hit.triangle == no_triangle) {
            return sky_seen(scene_, ray.direction);
        }
        const Surface surface = surface_at(scene_, ray, hit);
        const Material& material = *surface.material;
        glm::dvec3 found = sees_lamps && is_outer_side(scene_, ray, hit)
                               ? glm::dvec3(material.emission)
                               : glm::dvec3(0.0);
        if (bounces_left > 0) {
            const double clear = clear_part(material);
            const glm::dvec3 matte = (1.0 - clear) * glm::dvec3(material.diffuse);
            const bool is_smooth = clear > 0.0 || is_mirror(material);
            if (matte != glm::dvec3(0.0)) {
                found += matte * (from_lamp(surface, chance) + from_points(surface));
            }
            // Both ways are as likely where there are two.
            const double parts = is_smooth && matte != glm::dvec3(0.0) ? 2.0 : 1.0;
            if (is_smooth && (parts == 1.0 || chance.number() < 0.5)) {
                found += parts * beyond(ray, hit, surface, inside, bounces_left - 1, chance);
            } else if (matte != glm::dvec3(0.0)) {
                found += parts * matte * from_around(surface, inside, bounces_left - 1, chance);
            }
        }
        return inside.empty()
                   ? found
                   : found * left_after(*inside.back(), hit.t * glm::length(ray.direction));
    }

private:
    // What one point of all that glows sends to the surface, over pi.
    glm::dvec3 from_lamp(const Surface& surface, Chance& chance) const {
        if (glowing_.empty()) {
            return glm::dvec3(0.0);
        }
        const double whole = glowing_.back().area_up_to_here;
        const double wanted = whole * chance.number();
        const auto found =
            std::ranges::upper_bound(glowing_, wanted, {}, &GlowingTriangle::area_up_to_here);
        const GlowingTriangle& lamp = found == glowing_.end() ? glowing_.back() : *found;
        double u = chance.number();
        double v = chance.number();
        if (u + v > 1.0) { // the other half of the parallelogram
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const glm::dvec3 point = lamp.a + u * (lamp.b - lamp.a) + v * (lamp.c - lamp.a);
        const glm::dvec3 way = point - surface.point_above;
        const double distance = glm::length(way);
        const glm::dvec3 normal = glm::normalize(glm::cross(lamp.b - lamp.a, lamp.c - lamp.a));
        const double cosine = glm::dot(surface.shading_normal, way) / distance;
        const double lamp_cosine = -glm::dot(normal, way) / distance;
        if (cosine <= 0.0 || lamp_cosine <= 0.0 || glm::dot(surface.geometric_normal, way) <= 0.0 ||
            any_hit(ReferenceRay{.origin = surface.point_above,
                                 .direction = way,
                                 .t_max = before_the_lamp},
                    scene_.corners)) {
            return glm::dvec3(0.0);
        }
        return lamp.emission *
               (whole * cosine * lamp_cosine / (distance * distance) / std::numbers::pi);
    }

    // A point light has no distance: (N.L) times its colour, as everywhere in Raysteps.
    glm::dvec3 from_points(const Surface& surface) const {
        glm::dvec3 sum(0.0);
        if (!glowing_.empty()) {
            return sum;
        }
        for (const Light& light : scene_.lights) {
            const glm::dvec3 way = glm::dvec3(light.position) - surface.point_above;
            const double cosine = glm::dot(surface.shading_normal, way) / glm::length(way);
            if (cosine > 0.0 && glm::dot(surface.geometric_normal, way) > 0.0 &&
                !any_hit(ReferenceRay{.origin = surface.point_above,
                                      .direction = way,
                                      .t_max = before_the_lamp},
                         scene_.corners)) {
                sum += glm::dvec3(light.color) * cosine;
            }
        }
        return sum;
    }

    // The light from one direction by the cosine: the normal plus a point of the ball.
    glm::dvec3 from_around(const Surface& surface, const Bodies& inside, int bounces_left,
                           Chance& chance) const {
        const glm::dvec3 direction = surface.shading_normal + chance.direction();
        if (glm::dot(direction, surface.geometric_normal) <= 0.0) {
            return glm::dvec3(0.0);
        }
        return radiance({.origin = surface.point_above, .direction = direction}, inside,
                        bounces_left, false, chance);
    }

    // What a mirror shows, or glass: through it or off it, as likely as light goes.
    glm::dvec3 beyond(const ReferenceRay& ray, const ReferenceHit& hit, const Surface& surface,
                      const Bodies& inside, int bounces_left, Chance& chance) const {
        const double clear = clear_part(*surface.material);
        if (clear == 0.0) {
            return glm::dvec3(surface.material->specular) *
                   radiance({.origin = surface.point_above,
                             .direction = mirror_direction(surface, ray.direction)},
                            inside, bounces_left, true, chance);
        }
        const GlassWays ways = ways_at_glass(ray, surface, inside, is_outer_side(scene_, ray, hit));
        const bool reflects = chance.number() < ways.reflected_part;
        return clear * radiance(reflects ? ways.reflected : ways.refracted,
                                reflects ? ways.bodies.before : ways.bodies.behind, bounces_left,
                                true, chance);
    }

    const Scene& scene_;
    std::vector<GlowingTriangle> glowing_;
};

void check_request(const ReferencePathRequest& request) {
    if (request.width < 1 || request.height < 1 || request.samples < 2 || request.max_bounces < 0 ||
        request.max_bounces > 1000) {
        throw InputError(
            "reference paths: a picture needs pixels, 2 samples or more, and 0 to 1000 "
            "bounces.");
    }
}

} // namespace

std::vector<ReferencePixel> follow_reference_paths(const Scene& scene,
                                                   const ReferencePathRequest& request) {
    check_request(request);
    const Recursion recursion(scene);
    std::vector<ReferencePixel> pixels(static_cast<std::size_t>(request.width) *
                                       static_cast<std::size_t>(request.height));
    on_threads(all_cores, pixels.size(), [&](std::size_t i) {
        Chance chance((static_cast<std::uint64_t>(request.seed) << 32U) + i);
        const auto columns = static_cast<std::size_t>(request.width);
        const auto column = static_cast<double>(i % columns);
        const auto row = static_cast<double>(i / columns);
        glm::dvec3 sum(0.0);
        glm::dvec3 squares(0.0);
        for (int k = 0; k < request.samples; ++k) {
            const double right = chance.number() - 0.5;
            const double down = chance.number() - 0.5;
            const glm::dvec3 found =
                recursion.radiance(reference_ray(scene.camera, request.width, request.height,
                                                 column + right, row + down),
                                   {}, request.max_bounces, true, chance);
            sum += found;
            squares += found * found;
        }
        const auto count = static_cast<double>(request.samples);
        pixels[i].mean = sum / count;
        pixels[i].variance =
            glm::max(glm::dvec3(0.0), squares / count - pixels[i].mean * pixels[i].mean) /
            (count - 1.0);
    });
    return pixels;
}

} // namespace raysteps
