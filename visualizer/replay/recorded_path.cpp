#include "recorded_path.h"

#include "mirror/effects.h"
#include "scene/pack_scene.h"

#include <utility>

namespace raysteps {

namespace {

using Mirror = mirror::EffectParts<float>;

constexpr float faintest = 0.02f; // part of the light that a ray is still made for

Ray from_mirror(const Mirror::Ray& ray) {
    return {ray.origin, ray.direction, ray.t_min, ray.t_max};
}

Mirror::Hit to_mirror(const Hit& hit) {
    return {hit.t, hit.u, hit.v, hit.triangle};
}

// A ray still to be made.
struct Waiting {
    Mirror::Ray ray;
    RayRole role = RayRole::camera;
    int bounce = 0;
    float part = 1.0f;                // of the light of the pixel
    glm::uvec4 media = glm::uvec4(0); // light/media.glsl
};

// Last in, first out: the refracted ray comes first.
void add_parted(std::vector<Waiting>& waiting, const Waiting& now,
                const Mirror::GlassMeeting& meeting) {
    const float reflected = now.part * meeting.reflected_part;
    const float refracted = now.part - reflected;
    if (reflected > faintest) {
        waiting.push_back(
            {meeting.reflected, RayRole::mirror, now.bounce + 1, reflected, meeting.media_before});
    }
    if (refracted > faintest) {
        waiting.push_back({meeting.refracted, RayRole::refraction, now.bounce + 1, refracted,
                           meeting.media_behind});
    }
}

} // namespace

std::string ray_name(const PathRay& ray) {
    if (ray.role == RayRole::shadow) {
        return "shadow ray to light " + std::to_string(ray.number);
    }
    if (ray.role == RayRole::mirror) {
        return "mirror ray " + std::to_string(ray.number);
    }
    return ray.role == RayRole::refraction ? "refracted ray " + std::to_string(ray.number)
                                           : "camera ray";
}

std::vector<PathRay> record_path(const PathInput& input, const Ray& first, int max_bounces) {
    auto mirror = mirror::mirror_of<Mirror>(input.buffers);
    const std::vector<glm::vec4> glass = pack_glass(input.scene);
    mirror.glass_texels.texels = glass;
    std::vector<PathRay> path;
    std::vector<Waiting> waiting{{mirror::to_mirror<Mirror>(first), RayRole::camera, 0}};
    while (!waiting.empty()) {
        const Waiting now = waiting.back();
        waiting.pop_back();
        path.push_back(
            {now.role, now.bounce, input.recorder.record(from_mirror(now.ray), Question::nearest)});
        const Hit found = path.back().walk.hit;
        if (found.triangle == no_triangle) {
            continue;
        }
        const auto hit = to_mirror(found);
        const auto surface = mirror.surface_at(now.ray, hit);
        for (std::size_t i = 0; i < input.scene.lights.size(); ++i) {
            const auto shadow = mirror.shadow_ray(surface, input.scene.lights[i].position);
            if (!mirror.is_empty(shadow)) {
                path.push_back({RayRole::shadow, static_cast<int>(i) + 1,
                                input.recorder.record(from_mirror(shadow), Question::any)});
            }
        }
        if (now.bounce == max_bounces) {
            continue;
        }
        if (mirror.is_glass(found.triangle)) {
            add_parted(waiting, now, mirror.meet_glass(now.ray, hit, surface, now.media));
        } else if (surface.material.mirror) {
            waiting.push_back({mirror.mirror_ray(surface, now.ray), RayRole::mirror, now.bounce + 1,
                               now.part, now.media});
        }
    }
    return path;
}

Ray pixel_ray(const View& view, int width, int height, int column, int row) {
    Mirror mirror{};
    const float s = (static_cast<float>(column) + 0.5f) / static_cast<float>(width);
    const float t = (static_cast<float>(height - 1 - row) + 0.5f) / static_cast<float>(height);
    return from_mirror(mirror.primary_ray(mirror::to_mirror<Mirror>(view), s, t));
}

std::vector<Ray> pixel_rays(const View& view, int width, int height) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            rays.push_back(pixel_ray(view, width, height, column, row));
        }
    }
    return rays;
}

} // namespace raysteps
