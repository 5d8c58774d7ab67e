#include "scene/frame_scene.h"

#include "error/error.h"
#include "scene/glowing_lights.h"
#include "scene/obj_numbers.h"
#include "scene/view_frame.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

} // namespace

Camera frame_box(const Box& box, float aspect_ratio) {
    if (is_empty(box)) {
        return {};
    }
    const glm::dvec3 center = 0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper));
    const glm::dvec3 backward = glm::normalize(glm::dvec3(0.45, 0.35, 1.0));
    const ViewFrame frame = view_frame(-backward, {0.0, 1.0, 0.0});
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
    camera.vertical_field_of_view = static_cast<float>(field_of_view);
    return camera;
}

Camera frame_camera(const Scene& scene, float aspect_ratio) {
    const Camera camera = frame_box(bounds_of(scene.corners), aspect_ratio);
    const glm::vec3 farthest = glm::abs(camera.eye);
    if (!(std::max({farthest.x, farthest.y, farthest.z}) <= greatest_coordinate)) {
        throw InputError(scene.name +
                         ": this is too large for a camera in front of it: the eye would "
                         "be beyond 1.8e18. Scale it down, or name a camera.");
    }
    return camera;
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

Scene frame_scene(Scene scene, float aspect_ratio) {
    scene.camera = frame_camera(scene, aspect_ratio);
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

} // namespace raysteps
