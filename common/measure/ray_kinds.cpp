#include "measure/ray_kinds.h"

#include "basics/random_numbers.h"
#include "measure/cosine_direction.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"

#include <glm/geometric.hpp>

namespace raysteps {

namespace {

using Mirror = mirror::walks::every_triangle<float>;

Ray from_mirror_ray(const Mirror::Ray& ray) {
    return {ray.origin, ray.direction, ray.t_min, ray.t_max};
}

// In the unit ball, but for its very middle: as likely in every direction.
glm::vec3 point_in_ball(RandomNumbers& numbers) {
    glm::vec3 inside = numbers.in_cube();
    while (glm::dot(inside, inside) > 1.0f || glm::dot(inside, inside) < 1e-4f) {
        inside = numbers.in_cube();
    }
    return inside;
}

} // namespace

std::vector<RayKind> ray_kinds(const Scene& scene, std::span<const Ray> primary,
                               std::span<const Hit> hits, int seed) {
    const mirror::SceneBuffers buffers(scene);
    auto mirror = mirror::mirror_of<Mirror>(buffers);
    RandomNumbers numbers(seed);
    RayKind all{"primary", Query::closest, {primary.begin(), primary.end()}, Coherence::neighbours};
    RayKind shadow{"shadow", Query::any, {}, Coherence::neighbours};
    RayKind reflection{"reflection", Query::closest, {}, Coherence::alone};
    RayKind bounce{"bounce", Query::closest, {}, Coherence::alone};
    for (std::size_t i = 0; i < primary.size(); ++i) {
        all.from.push_back(i);
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
                shadow.from.push_back(i);
            }
        }
        reflection.rays.push_back(from_mirror_ray(mirror.mirror_ray(surface, incoming)));
        reflection.from.push_back(i);
        bounce.rays.push_back({surface.origin,
                               cosine_direction(surface.geometric_normal, point_in_ball(numbers)),
                               0.0f, mirror.farthest});
        bounce.from.push_back(i);
    }
    std::vector<RayKind> kinds{std::move(all)};
    for (RayKind& kind : {std::ref(shadow), std::ref(reflection), std::ref(bounce)}) {
        if (!kind.rays.empty()) {
            kinds.push_back(std::move(kind));
        }
    }
    return kinds;
}

} // namespace raysteps
