#include "measure/ray_kinds.h"

#include "mirror/every_triangle.h"
#include "mirror/mirror_scene.h"
#include "scene/random_numbers.h"

#include <glm/geometric.hpp>

namespace raysteps {

namespace {

using Mirror = mirror::EveryTriangleWatertight<float>;

Ray from_mirror_ray(const Mirror::Ray& ray) {
    return {ray.origin, ray.direction, ray.t_min, ray.t_max};
}

// A normal plus a point on the unit sphere is a direction with the density of the cosine.
glm::vec3 cosine_direction(RandomNumbers& numbers, const glm::vec3& normal) {
    glm::vec3 inside = numbers.in_cube();
    while (glm::dot(inside, inside) > 1.0f || glm::dot(inside, inside) < 1e-4f) {
        inside = numbers.in_cube();
    }
    const glm::vec3 direction = normal + glm::normalize(inside);
    return glm::dot(direction, direction) > 1e-4f ? direction : normal;
}

} // namespace

std::vector<RayKind> ray_kinds(const Scene& scene, std::span<const Ray> primary,
                               std::span<const Hit> hits, int seed) {
    const mirror::SceneBuffers buffers(scene);
    auto mirror = mirror::mirror_of<Mirror>(buffers);
    RandomNumbers numbers(seed);
    RayKind shadow{"shadow", Query::any, {}};
    RayKind reflection{"reflection", Query::closest, {}};
    RayKind bounce{"bounce", Query::closest, {}};
    for (std::size_t i = 0; i < primary.size(); ++i) {
        if (hits[i].triangle < 0) {
            continue;
        }
        const Mirror::Hit hit{hits[i].t, hits[i].u, hits[i].v, hits[i].triangle};
        const Mirror::Ray incoming = mirror::to_mirror<Mirror>(primary[i]);
        const auto surface = mirror.surface_at(incoming, hit);
        if (!scene.lights.empty()) {
            const Ray ray =
                from_mirror_ray(mirror.shadow_ray(surface, scene.lights.front().position));
            if (ray.t_max >= ray.t_min) {
                shadow.rays.push_back(ray);
            }
        }
        reflection.rays.push_back(from_mirror_ray(mirror.mirror_ray(surface, incoming)));
        bounce.rays.push_back({surface.origin, cosine_direction(numbers, surface.geometric_normal),
                               0.0f, mirror.farthest});
    }
    std::vector<RayKind> kinds{{"primary", Query::closest, {primary.begin(), primary.end()}}};
    for (RayKind& kind : {std::ref(shadow), std::ref(reflection), std::ref(bounce)}) {
        if (!kind.rays.empty()) {
            kinds.push_back(std::move(kind));
        }
    }
    return kinds;
}

} // namespace raysteps
