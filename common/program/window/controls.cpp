#include "program/window/controls.h"

namespace raysteps {

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
    controls.camera =
        drag(controls.camera, controls.motion, controls.cursor, place, controls.window_size);
    controls.cursor = place;
    return controls;
}

Controls scroll(Controls controls, double notches) {
    controls.camera = turn_wheel(controls.camera, notches);
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
