#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

enum class Button { left, middle, right };

struct Modifiers {
    bool shift = false;
    bool control = false;
};

// What a drag does to the camera.
enum class Motion { none, orbit, roll, pan, dolly };

// VTK's: left orbits, with control it rolls, with shift it pans, with both it zooms; middle pans,
// right zooms.
Motion motion_of(Button button, const Modifiers& modifiers);

// The camera after the mouse went from one place in the window to another. Places and size are in
// the units of the window's system, with y downward.
Camera drag(const Camera& camera, Motion motion, const glm::dvec2& from, const glm::dvec2& to,
            const glm::dvec2& window_size);

// The camera after so many notches of the wheel, nearer where they are positive.
Camera turn_wheel(const Camera& camera, double notches);

// How far a window lets the eye move from where it starts, along each axis: 15 times its distance
// from the target. Structures are built for rays from so far away (structure/padding.h), and a
// scene is a few pixels wide from there.
float room_to_move(const Camera& start);

// What mouse and keys do, in the words of the panel.
struct ControlLine {
    char letter = 0; // 0: of the mouse
    std::string input;
    std::string effect;
};

const std::vector<ControlLine>& control_lines();

// A rectangle of the window that a panel covers; the mouse is the panel's there.
struct Covered {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};

// What the mouse did there.
struct PanelEvent {
    glm::dvec2 place{0.0};
    bool pressed = false; // the left button, from now on
    double notches = 0.0;
    bool only_moves = false;
};

// A letter that is none of those above.
struct ChoiceKey {
    char letter = 0;
    bool shift = false;
};

// What the person at the window wants, as told by the events so far. Events come while another
// library runs, which no exception may cross: so they only change these values, and the window's
// loop carries out what is asked.
struct Controls {
    Camera start;
    Camera camera;
    glm::dvec2 window_size{1.0};
    glm::dvec2 cursor{0.0};
    std::optional<Button> held; // the button that drags
    Motion motion = Motion::none;
    bool help = false; // the panel is shown
    bool close = false;
    Covered panel;
    bool on_panel = false; // the left button was pressed there
    // Asked for, and taken back by the loop once it is done: what the camera saw when S or C was
    // pressed, since more events may have come before the loop looks.
    std::optional<Camera> camera_to_save;
    std::optional<Camera> camera_to_print;
    std::vector<PanelEvent> panel_events;
    std::vector<ChoiceKey> choice_keys;
    std::optional<glm::dvec2> clicked; // beside the panel, without a drag
    bool read_shaders = false;
    bool must_redraw = true;
    glm::dvec2 pressed_at{0.0};
};

Controls start_controls(const Camera& start);

Controls press_button(Controls controls, Button button, const Modifiers& modifiers);
Controls release_button(Controls controls, Button button);
Controls move_cursor(Controls controls, const glm::dvec2& place);
Controls scroll(Controls controls, double notches);

// The letter that is on the key, in lower case.
Controls press_key(Controls controls, char letter, bool shift = false);

} // namespace raysteps
