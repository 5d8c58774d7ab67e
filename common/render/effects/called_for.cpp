#include "render/effects/plan.h"

#include "scene/scene.h"
#include "scene/view.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <functional>

namespace raysteps {

namespace {

constexpr std::size_t most_names = 3;

std::string counted(long count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// What the materials with that property are called and how many triangles they have; empty where no
// triangle has such a material.
std::string reason_of(const Scene& scene, const std::vector<int>& triangles,
                      const std::function<bool(const Material&)>& has) {
    std::string names;
    std::size_t materials = 0;
    long count = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (triangles[i] == 0 || !has(scene.materials[i])) {
            continue;
        }
        ++materials;
        count += triangles[i];
        if (materials <= most_names) {
            names += (names.empty() ? "" : ", ") + scene.materials[i].name;
        }
    }
    if (materials == 0) {
        return "";
    }
    const std::string more = materials > most_names ? ", ..." : "";
    return (materials == 1 ? "material "
                           : counted(static_cast<long>(materials), "material") + " ") +
           names + more + ", " + counted(count, "triangle");
}

class Calls {
public:
    void add(Effect effect, const std::string& reason) {
        if (!reason.empty()) {
            calls_.push_back({effect, reason});
        }
    }

    bool has(Effect effect) const {
        return std::any_of(calls_.begin(), calls_.end(),
                           [&](const EffectCall& call) { return call.effect == effect; });
    }

    std::vector<EffectCall> in_order() {
        std::sort(calls_.begin(), calls_.end(),
                  [](const EffectCall& a, const EffectCall& b) { return a.effect < b.effect; });
        return std::move(calls_);
    }

private:
    std::vector<EffectCall> calls_;
};

long count_shining(const Scene& scene) {
    return std::count_if(scene.lights.begin(), scene.lights.end(),
                         [](const Light& light) { return light.color != glm::vec3(0.0f); });
}

void add_camera_effects(Calls& calls, const Scene& scene) {
    const Camera& camera = scene.camera;
    if (camera.samples > 1) {
        calls.add(Effect::antialiasing,
                  "the camera wants " + std::to_string(camera.samples) + " rays per pixel");
    }
    if (camera.aperture > 0.0f) {
        calls.add(Effect::depth_of_field, "the camera has a lens");
    }
    if (scene.sky) {
        calls.add(Effect::sky, "the scene has a sky");
    }
}

void add_light_effects(Calls& calls, const Scene& scene, const std::vector<int>& seen) {
    const long lights = count_shining(scene);
    //# exercise 9.7: a hunt, for an effect that nothing calls for
    if (lights == 0) {
        return;
    }
    const std::string under = "; " + counted(lights, "light");
    const auto lit = [&](Effect effect, const std::function<bool(const Material&)>& has) {
        const std::string reason = reason_of(scene, seen, has);
        calls.add(effect, reason.empty() ? "" : reason + under);
    };
    lit(Effect::diffuse, [](const Material& material) {
        return transparency(material) < 1.0f && material.diffuse != glm::vec3(0.0f);
    });
    lit(Effect::highlights, has_highlight);
    const bool shows_light = calls.has(Effect::diffuse) || calls.has(Effect::highlights);
    if (!shows_light || triangle_count(scene) < 2) {
        return;
    }
    calls.add(Effect::shadows, counted(lights, "light") + ", " +
                                   counted(triangle_count(scene), "triangle") +
                                   " that may stand before " + (lights == 1 ? "it" : "them"));
    const long with_area = std::count_if(scene.lights.begin(), scene.lights.end(), has_area);
    calls.add(Effect::soft_shadows,
              with_area == 0 ? "" : counted(with_area, "light") + " with an area");
    calls.add(Effect::glass_shadows,
              reason_of(scene, triangles_of_materials(scene),
                        [](const Material& material) { return is_glass(material); }));
    //# end
}

// The eye is in all of these planes: the four sides, and the one that parts what is before the eye
// from what is behind it. Their normals point out of the view.
struct Frustum {
    glm::dvec3 eye;
    std::array<glm::dvec3, 5> outward;
};

Frustum frustum_of(const Camera& camera, double aspect_ratio) {
    const View view = view_of(camera, aspect_ratio);
    const glm::dvec3 lower_left(view.lower_left);
    const glm::dvec3 right(view.right);
    const glm::dvec3 up(view.up);
    const glm::dvec3 middle = lower_left + 0.5 * right + 0.5 * up;
    const auto side = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 normal = glm::normalize(glm::cross(a, b));
        return glm::dot(normal, middle) > 0.0 ? -normal : normal;
    };
    const glm::dvec3 lower_right = lower_left + right;
    const glm::dvec3 upper_left = lower_left + up;
    const glm::dvec3 upper_right = lower_right + up;
    return {glm::dvec3(view.eye),
            {side(lower_left, lower_right), side(upper_left, upper_right),
             side(lower_left, upper_left), side(lower_right, upper_right),
             -glm::normalize(middle)}};
}

// The view's corners were rounded to float, relative to lengths of about 1: 2^-24. So a point this
// much of its distance outside is surely outside.
constexpr double surely = 1e-6;

bool is_outside(const Frustum& frustum, const glm::vec3* corners) {
    for (const glm::dvec3& outward : frustum.outward) {
        bool all_outside = true;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 from_eye = glm::dvec3(corners[i]) - frustum.eye;
            all_outside =
                all_outside && glm::dot(outward, from_eye) > surely * glm::length(from_eye);
        }
        if (all_outside) {
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<EffectCall> effects_called_for(const Scene& scene, double aspect_ratio,
                                           float faintest) {
    const std::vector<int> seen = triangles_in_view(scene, aspect_ratio);
    Calls calls;
    add_camera_effects(calls, scene);
    calls.add(Effect::cutouts,
              reason_of(scene, triangles_of_materials(scene),
                        [](const Material& material) { return !material.cutout_map.empty(); }));
    add_light_effects(calls, scene, seen);
    calls.add(Effect::emissive_maps, reason_of(scene, seen, [](const Material& material) {
                  return !material.emissive_map.empty();
              }));
    if (calls.has(Effect::diffuse) || calls.has(Effect::highlights)) {
        calls.add(Effect::normal_maps, reason_of(scene, seen, [](const Material& material) {
                      return !material.normal_map.empty();
                  }));
    }
    if (calls.has(Effect::diffuse)) {
        calls.add(Effect::textures, reason_of(scene, seen, has_texture));
        calls.add(Effect::vertex_colors,
                  scene.corner_colors.empty()
                      ? ""
                      : counted(triangle_count(scene), "triangle") + " with colours at corners");
    }
    calls.add(Effect::mirrors, reason_of(scene, seen, [&](const Material& material) {
                  const glm::vec3& kept = material.specular;
                  return is_mirror(material) && !is_glass(material) &&
                         std::max({kept.x, kept.y, kept.z}) > faintest;
              }));
    calls.add(Effect::refraction, reason_of(scene, seen, is_glass));
    calls.add(Effect::absorption, reason_of(scene, seen, absorbs));
    return calls.in_order();
}

std::vector<int> triangles_of_materials(const Scene& scene) {
    std::vector<int> counts(scene.materials.size(), 0);
    for (const int material : scene.triangle_materials) {
        ++counts[material];
    }
    return counts;
}

std::vector<int> triangles_in_view(const Scene& scene, double aspect_ratio) {
    if (scene.camera.aperture > 0.0f) {
        return triangles_of_materials(scene);
    }
    const Frustum frustum = frustum_of(scene.camera, aspect_ratio);
    std::vector<int> counts(scene.materials.size(), 0);
    for (std::size_t i = 0; i < scene.triangle_materials.size(); ++i) {
        const auto material = static_cast<std::size_t>(scene.triangle_materials[i]);
        counts[material] += is_outside(frustum, &scene.corners[3 * i]) ? 0 : 1;
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const Material& material = scene.materials[i];
        if (counts[i] > 0 && (is_mirror(material) || is_glass(material))) {
            return triangles_of_materials(scene);
        }
    }
    return counts;
}

} // namespace raysteps
