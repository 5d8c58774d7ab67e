#include "scene/frame_scene.h"

#include "basics/error.h"
#include "scene/obj/obj_file.h"
#include "scene/view.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace raysteps {

namespace {

constexpr double field_of_view = 35.0; // degrees
constexpr double margin = 1.02;        // how much farther away than is needed to see everything

std::array<glm::dvec3, 8> corners_of(const Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        corners[i] = {(i & 1) == 0 ? box.lower.x : box.upper.x,
                      (i & 2) == 0 ? box.lower.y : box.upper.y,
                      (i & 4) == 0 ? box.lower.z : box.upper.z};
    }
    return corners;
}

double greatest_coordinate_of(const Box& box) {
    double greatest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        greatest =
            std::max<double>({greatest, std::abs(box.lower[axis]), std::abs(box.upper[axis])});
    }
    return greatest;
}

using Corners = std::array<glm::vec3, 3>;

Corners corners_of(const Scene& scene, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]};
}

bool glows(const Scene& scene, int triangle) {
    const int material = scene.triangle_materials[triangle];
    return scene.materials[material].emission != glm::vec3(0.0f);
}

// Where in the first triangle the corner is that the second one does not have; none where they do
// not share an edge.
std::optional<std::size_t> lone_corner(const Corners& first, const Corners& second) {
    std::optional<std::size_t> lone;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::find(second.begin(), second.end(), first[i]) == second.end()) {
            if (lone) {
                return std::nullopt;
            }
            lone = i;
        }
    }
    return lone;
}

float greatest_of(const glm::vec3& vector) {
    const glm::vec3 sizes = glm::abs(vector);
    return std::max({sizes.x, sizes.y, sizes.z});
}

// The parallelogram of two triangles that share a diagonal, without a colour; none where they make
// another shape. Its diagonals have the same middle. Each coordinate of a file is rounded by 2^-24
// of its size, and by a transform a few times more, so sums of two corners agree to 2^-20 of it.
std::optional<Light> parallelogram(const Corners& first, const Corners& second) {
    const std::optional<std::size_t> one = lone_corner(first, second);
    const std::optional<std::size_t> other = lone_corner(second, first);
    if (!one || !other) {
        return std::nullopt;
    }
    const glm::vec3 corner = first[*one];
    const glm::vec3 next = first[(*one + 1) % 3];
    const glm::vec3 last = first[(*one + 2) % 3];
    const float greatest = std::max({greatest_of(corner), greatest_of(next), greatest_of(last)});
    const glm::vec3 gap = (next - corner) - (second[*other] - last);
    const Light light{0.5f * next + 0.5f * last, {}, next - corner, last - corner};
    const bool has_size =
        glm::cross(glm::dvec3(light.across), glm::dvec3(light.along)) != glm::dvec3(0.0);
    if (!has_size || greatest_of(gap) > std::ldexp(greatest, -20)) {
        return std::nullopt;
    }
    return light;
}

} // namespace

Camera frame_box(const Box& box, float aspect_ratio, const ViewDirection& direction) {
    if (is_empty(box)) {
        return {};
    }
    const glm::dvec3 center = 0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper));
    const glm::dvec3 backward = glm::normalize(direction.backward);
    const ViewFrame frame = view_frame(-backward, direction.up);
    const double up_slope = std::tan(glm::radians(field_of_view / 2.0));
    const double right_slope = up_slope * static_cast<double>(aspect_ratio);

    // A corner is in the picture where its distance beside the line of sight is at most the slope
    // times its depth; this is the smallest distance of the eye at which all corners are.
    double distance = 0.0;
    for (const glm::dvec3& corner : corners_of(box)) {
        const glm::dvec3 offset = corner - center;
        const double nearer = glm::dot(offset, backward);
        distance = std::max({distance, nearer + std::abs(glm::dot(offset, frame.up)) / up_slope,
                             nearer + std::abs(glm::dot(offset, frame.right)) / right_slope});
    }
    // The eye and the target are rounded to floats, by up to 2^-24 of the greatest coordinate, so
    // the distance is kept far above that. A point at the origin has no size at all.
    distance = std::max(margin * distance, std::ldexp(greatest_coordinate_of(box), -12));
    if (distance < std::numeric_limits<float>::min()) {
        distance = 1.0;
    }

    Camera camera;
    camera.eye = glm::vec3(center + distance * backward);
    camera.target = glm::vec3(center);
    camera.up = glm::vec3(direction.up);
    camera.vertical_field_of_view = static_cast<float>(field_of_view);
    return camera;
}

Camera frame_camera(const Scene& scene, float aspect_ratio, const std::optional<Camera>& instead) {
    return camera_or(frame_box(bounds_of(scene.corners), aspect_ratio), instead, scene.name);
}

Camera camera_or(const Camera& camera, const std::optional<Camera>& instead,
                 const std::string& scene_name) {
    const float farthest = greatest_of(camera.eye);
    if (farthest <= greatest_coordinate) {
        return camera;
    }
    if (instead && greatest_of(instead->eye) <= greatest_coordinate) {
        return *instead;
    }
    const double scale =
        std::exp2(-std::ceil(std::log2(static_cast<double>(farthest) / greatest_coordinate)));
    throw InputError(fmt::format(
        "{}: this is too large for a camera in front of it: the eye would be at {:.2g}, beyond "
        "1.8e18. Name one with --camera, or in a scene file, a .toml with [camera]; or let that "
        "file make the model smaller, with scale = {}, which changes no digit.",
        scene_name, farthest, scale));
}

std::vector<Light> place_lights(const Camera& camera) {
    const glm::dvec3 eye(camera.eye);
    const glm::dvec3 line_of_sight = glm::dvec3(camera.target) - eye;
    const ViewFrame frame = view_frame(line_of_sight, camera.up);
    const double distance = glm::length(line_of_sight);
    const glm::dvec3 bright = eye + distance * (-0.7 * frame.right + 0.8 * frame.up);
    const glm::dvec3 dim = eye + distance * (0.9 * frame.right + 0.2 * frame.up);
    return {{glm::vec3(bright), {0.84f, 0.80f, 0.74f}}, {glm::vec3(dim), {0.24f, 0.27f, 0.33f}}};
}

std::vector<Light> find_lights(Scene& scene) {
    std::vector<Light> lights = glowing_lights(scene);
    const std::vector<Light> placed = place_lights(scene.camera);
    if (lights.empty()) {
        return placed;
    }
    lights.push_back(placed.back());
    return lights;
}

Scene frame_scene(Scene scene, float aspect_ratio, const std::optional<Camera>& instead) {
    scene.camera = frame_camera(scene, aspect_ratio, instead);
    scene.lights = find_lights(scene);
    scene.background = calm_background;
    return scene;
}

Camera keep_square_in_view(const Camera& camera, float aspect_ratio) {
    if (aspect_ratio >= 1.0f) {
        return camera;
    }
    const double half_angle =
        glm::radians(static_cast<double>(camera.vertical_field_of_view)) / 2.0;
    const double slope = std::tan(half_angle) / static_cast<double>(aspect_ratio);
    Camera wider = camera;
    wider.vertical_field_of_view = static_cast<float>(glm::degrees(2.0 * std::atan(slope)));
    return wider;
}

std::vector<Light> glowing_lights(Scene& scene) {
    std::vector<Light> lights;
    std::size_t unused = 0;
    for (int i = 0; i < triangle_count(scene); ++i) {
        if (!glows(scene, i)) {
            continue;
        }
        const bool has_next = i + 1 < triangle_count(scene) && glows(scene, i + 1);
        std::optional<Light> light =
            has_next && lights.size() < most_glowing_lights
                ? parallelogram(corners_of(scene, i), corners_of(scene, i + 1))
                : std::nullopt;
        if (!light) {
            ++unused;
            continue;
        }
        const int material = scene.triangle_materials[i];
        const glm::vec3 emission = scene.materials[material].emission;
        light->color = emission / std::max(1.0f, greatest_of(emission));
        lights.push_back(*light);
        ++i; // the other half
    }
    if (unused > 0) {
        scene.messages.push_back(std::to_string(unused) +
                                 (unused == 1 ? " triangle glows" : " triangles glow") +
                                 " (Ke) and light nothing else: lights are the first " +
                                 std::to_string(most_glowing_lights) +
                                 " parallelograms that glow. Name lights in a scene file.");
    }
    return lights;
}

} // namespace raysteps
