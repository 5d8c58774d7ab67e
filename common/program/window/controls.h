#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>

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
    bool help = false;
    bool close = false;
    // Asked for, and taken back by the loop once it is done: what the camera saw when S or C was
    // pressed, since more events may have come before the loop looks.
    std::optional<Camera> camera_to_save;
    std::optional<Camera> camera_to_print;
    bool must_redraw = true;
};

Controls start_controls(const Camera& start);

Controls press_button(Controls controls, Button button, const Modifiers& modifiers);
Controls release_button(Controls controls, Button button);
Controls move_cursor(Controls controls, const glm::dvec2& place);
Controls scroll(Controls controls, double notches);

// The letter that is on the key, in lower case; others than those of the help are passed over.
Controls press_key(Controls controls, char letter);

} // namespace raysteps
