#include "effects/in_view.h"

#include "scene/material_effects.h"
#include "scene/view.h"

#include <glm/geometric.hpp>

#include <array>

namespace raysteps {

namespace {

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

std::vector<int> triangles_of_materials(const Scene& scene) {
    std::vector<int> counts(scene.materials.size(), 0);
    for (const int material : scene.triangle_materials) {
        ++counts[static_cast<std::size_t>(material)];
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
