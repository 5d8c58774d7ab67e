#include "replay/recorded_path.h"

#include "mirror/every_triangle.h"

#include <utility>

namespace raysteps {

namespace {

using Mirror = mirror::EveryTriangleWatertight<float>;

Ray from_mirror(const Mirror::Ray& ray) {
    return {ray.origin, ray.direction, ray.t_min, ray.t_max};
}

Mirror::Hit to_mirror(const Hit& hit) {
    return {hit.t, hit.u, hit.v, hit.triangle};
}

} // namespace

std::string ray_name(const PathRay& ray) {
    if (ray.role == RayRole::shadow) {
        return "shadow ray to light " + std::to_string(ray.number);
    }
    return ray.role == RayRole::mirror ? "mirror ray " + std::to_string(ray.number) : "camera ray";
}

std::vector<PathRay> record_path(const PathInput& input, const Ray& first, int max_bounces) {
    auto mirror = mirror::mirror_of<Mirror>(input.buffers);
    std::vector<PathRay> path;
    auto ray = mirror::to_mirror<Mirror>(first);
    for (int bounce = 0;; ++bounce) {
        const RayRole role = bounce == 0 ? RayRole::camera : RayRole::mirror;
        path.push_back({role, bounce, input.recorder.record(from_mirror(ray), Question::nearest)});
        const Hit hit = path.back().walk.hit;
        if (hit.triangle == no_triangle) {
            return path;
        }
        const auto surface = mirror.surface_at(ray, to_mirror(hit));
        for (std::size_t i = 0; i < input.scene.lights.size(); ++i) {
            const auto shadow = mirror.shadow_ray(surface, input.scene.lights[i].position);
            if (!mirror.is_empty(shadow)) {
                path.push_back({RayRole::shadow, static_cast<int>(i) + 1,
                                input.recorder.record(from_mirror(shadow), Question::any)});
            }
        }
        if (!surface.material.mirror || bounce == max_bounces) {
            return path;
        }
        ray = mirror.mirror_ray(surface, ray);
    }
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
