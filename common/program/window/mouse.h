#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>

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

} // namespace raysteps
