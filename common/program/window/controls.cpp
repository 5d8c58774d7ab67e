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

// So many pixels may the mouse slip during a click.
constexpr double click_room = 3.0;

bool is_over_panel(const Controls& controls, const glm::dvec2& place) {
    const Covered& panel = controls.panel;
    return controls.help && place.x >= panel.from.x && place.y >= panel.from.y &&
           place.x < panel.to.x && place.y < panel.to.y;
}

// One move after another is one.
void tell_panel(Controls& controls, const PanelEvent& event) {
    std::vector<PanelEvent>& events = controls.panel_events;
    if (event.only_moves && !events.empty() && events.back().only_moves) {
        events.pop_back();
    }
    events.push_back(event);
    controls.must_redraw = true;
}

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

const std::vector<ControlLine>& control_lines() {
    static const std::vector<ControlLine> lines{
        {0, "left mouse", "turn the scene"},  {0, "shift left, middle", "move it"},
        {0, "right, wheel", "zoom"},          {0, "control left", "tilt"},
        {'r', "R", "back to the first view"}, {'s', "S", "save the picture"},
        {'c', "C", "print the camera"},       {'h', "H", "hide this panel"},
        {'q', "Q, Escape", "close"},
    };
    return lines;
}

// Of two buttons held, the one pressed last drags.
Controls press_button(Controls controls, Button button, const Modifiers& modifiers) {
    if (is_over_panel(controls, controls.cursor)) {
        controls.on_panel = controls.on_panel || button == Button::left;
        tell_panel(controls, {controls.cursor, controls.on_panel});
        return controls;
    }
    controls.held = button;
    controls.motion = motion_of(button, modifiers);
    controls.pressed_at = controls.cursor;
    return controls;
}

Controls release_button(Controls controls, Button button) {
    if (controls.on_panel && button == Button::left) {
        controls.on_panel = false;
        tell_panel(controls, {controls.cursor, false});
        return controls;
    }
    const glm::dvec2 slipped = glm::abs(controls.cursor - controls.pressed_at);
    if (button == Button::left && controls.motion == Motion::orbit &&
        std::max(slipped.x, slipped.y) <= click_room) {
        controls.clicked = controls.cursor;
    }
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
    if (controls.help && controls.motion == Motion::none) {
        tell_panel(controls, {place, controls.on_panel, 0.0, true});
    }
    return controls;
}

Controls scroll(Controls controls, double notches) {
    if (is_over_panel(controls, controls.cursor)) {
        tell_panel(controls, {controls.cursor, controls.on_panel, notches});
        return controls;
    }
    move_camera(controls, turn_wheel(controls.camera, notches));
    return controls;
}

Controls press_key(Controls controls, char letter, bool shift) {
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
        controls.choice_keys.push_back({letter, shift});
        break;
    }
    return controls;
}

} // namespace raysteps
