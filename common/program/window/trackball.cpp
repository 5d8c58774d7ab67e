#include "program/window/trackball.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

// VTK: 20 / size * MotionFactor, which is 10, for each pixel.
constexpr double degrees_a_window = 200.0;

// Under 1e-4 of the target's distance from the origin, a float's step of 2^-24 would turn the line
// of sight by more than half a milliradian: about a pixel.
constexpr double nearest_part = 1e-4;
constexpr double nearest_distance = 1e-15;

// The largest coordinate of a scene is of this size.
constexpr double farthest_distance = 1e18;

struct ViewFrame {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 back; // from the target to the eye
    double distance;
};

ViewFrame frame_of(const Camera& camera) {
    const glm::dvec3 to_eye = glm::dvec3(camera.eye) - glm::dvec3(camera.target);
    const double distance = glm::length(to_eye);
    const glm::dvec3 back = to_eye / distance;
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back));
    return {right, glm::cross(back, right), back, distance};
}

Camera placed(Camera camera, const ViewFrame& frame) {
    camera.eye = glm::vec3(glm::dvec3(camera.target) + frame.distance * frame.back);
    camera.up = glm::vec3(frame.up);
    return camera;
}

} // namespace

Camera orbit(const Camera& camera, const MouseMove& move) {
    ViewFrame frame = frame_of(camera);
    const double length = glm::length(move);
    if (length == 0.0) {
        return camera;
    }
    // The eye goes left where the mouse goes right, and down where it goes up.
    const glm::dvec3 axis = (move.y * frame.right - move.x * frame.up) / length;
    const glm::dquat turn = glm::angleAxis(glm::radians(degrees_a_window * length), axis);
    frame.back = turn * frame.back;
    frame.up = turn * frame.up;
    return placed(camera, frame);
}

Camera pan(const Camera& camera, const MouseMove& move, double aspect_ratio) {
    const ViewFrame frame = frame_of(camera);
    const double half_angle = glm::radians(0.5 * camera.vertical_field_of_view);
    const double height = 2.0 * frame.distance * std::tan(half_angle);
    const glm::dvec3 shift = -height * (aspect_ratio * move.x * frame.right + move.y * frame.up);
    Camera moved = camera;
    moved.target = glm::vec3(glm::dvec3(camera.target) + shift);
    return placed(moved, frame);
}

Camera dolly(const Camera& camera, double factor) {
    ViewFrame frame = frame_of(camera);
    const double target_distance = glm::length(glm::dvec3(camera.target));
    const double nearest = std::max(nearest_distance, nearest_part * target_distance);
    const double wanted = frame.distance / factor;
    const bool too_near = wanted < frame.distance && wanted < nearest;
    const bool too_far = wanted > frame.distance && wanted > farthest_distance;
    if (too_near || too_far) {
        return camera;
    }
    frame.distance = wanted;
    return placed(camera, frame);
}

Camera roll(const Camera& camera, double angle) {
    ViewFrame frame = frame_of(camera);
    // The picture turns counter-clockwise where the camera turns clockwise.
    frame.up = glm::angleAxis(-angle, frame.back) * frame.up;
    return placed(camera, frame);
}

} // namespace raysteps
