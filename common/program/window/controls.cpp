#include "program/window/controls.h"

#include "program/window/trackball.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

// VTK: Dolly(1.1 ^ (MotionFactor * dy / half the height)), and 1.1 ^ (MotionFactor * 0.2) a notch.
constexpr double zoom = 1.1;
constexpr double zoom_powers_a_window = 20.0;
constexpr double zoom_powers_a_notch = 2.0;

double angle_about_middle(const glm::dvec2& place, const glm::dvec2& window_size) {
    return std::atan2(0.5 * window_size.y - place.y, place.x - 0.5 * window_size.x);
}

} // namespace

Motion motion_of(Button button, const Modifiers& modifiers) {
    if (button == Button::middle) {
        return Motion::pan;
    }
    if (button == Button::right || (modifiers.shift && modifiers.control)) {
        return Motion::dolly;
    }
    if (modifiers.shift) {
        return Motion::pan;
    }
    return modifiers.control ? Motion::roll : Motion::orbit;
}

Camera drag(const Camera& camera, Motion motion, const glm::dvec2& from, const glm::dvec2& to,
            const glm::dvec2& window_size) {
    // A minimised window has no area to divide by.
    const glm::dvec2 size = glm::max(window_size, glm::dvec2(1.0));
    const MouseMove move{(to.x - from.x) / size.x, (from.y - to.y) / size.y};
    switch (motion) {
    case Motion::orbit:
        return orbit(camera, move);
    case Motion::roll:
        return roll(camera, angle_about_middle(to, size) - angle_about_middle(from, size));
    case Motion::pan:
        return pan(camera, move, size.x / size.y);
    case Motion::dolly:
        return dolly(camera, std::pow(zoom, zoom_powers_a_window * move.y));
    case Motion::none:
        break;
    }
    return camera;
}

Camera turn_wheel(const Camera& camera, double notches) {
    return dolly(camera, std::pow(zoom, zoom_powers_a_notch * notches));
}

float room_to_move(const Camera& start) {
    return 15.0f * glm::distance(start.eye, start.target);
}

namespace {

// Where the eye would leave its room, the camera stays as it is.
void move_camera(Controls& controls, const Camera& moved) {
    const glm::vec3 away = glm::abs(moved.eye - controls.start.eye);
    if (std::max({away.x, away.y, away.z}) <= room_to_move(controls.start)) {
        controls.camera = moved;
    }
}

} // namespace

Controls start_controls(const Camera& start) {
    Controls controls;
    controls.start = start;
    controls.camera = start;
    return controls;
}

// Of two buttons held, the one pressed last drags.
Controls press_button(Controls controls, Button button, const Modifiers& modifiers) {
    controls.held = button;
    controls.motion = motion_of(button, modifiers);
    return controls;
}

Controls release_button(Controls controls, Button button) {
    if (controls.held == button) {
        controls.held.reset();
        controls.motion = Motion::none;
    }
    return controls;
}

Controls move_cursor(Controls controls, const glm::dvec2& place) {
    move_camera(controls, drag(controls.camera, controls.motion, controls.cursor, place,
                               controls.window_size));
    controls.cursor = place;
    return controls;
}

Controls scroll(Controls controls, double notches) {
    move_camera(controls, turn_wheel(controls.camera, notches));
    return controls;
}

Controls press_key(Controls controls, char letter) {
    switch (letter) {
    case 'h':
        controls.help = !controls.help;
        controls.must_redraw = true;
        break;
    case 's':
        controls.camera_to_save = controls.camera;
        break;
    case 'r':
        controls.camera = controls.start;
        break;
    case 'c':
        controls.camera_to_print = controls.camera;
        break;
    case 'q':
        controls.close = true;
        break;
    default:
        break;
    }
    return controls;
}

} // namespace raysteps
