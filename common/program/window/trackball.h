#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>

namespace raysteps {

// The motions of a trackball, as vtkInteractorStyleTrackballCamera makes them (Schroeder, Martin,
// Lorensen, "The Visualization Toolkit", 4th ed., 2006): the scene seems to follow the mouse.
// All compute in double, and leave a camera whose up is a unit vector square to its line of sight.

// How far the mouse moves, in widths of the window to the right and in heights of it upward.
using MouseMove = glm::dvec2;

// Turns eye and up about the target, by 200 degrees for the whole window. VTK turns about one axis
// and then about another; this turns once about the axis that is square to the move, so that the
// opposite move takes it back.
Camera orbit(const Camera& camera, const MouseMove& move);

// Moves eye and target alike, so that what lies at the target's distance stays under the mouse.
Camera pan(const Camera& camera, const MouseMove& move, double aspect_ratio);

// Divides the distance of eye and target by the factor, which is over 0. Where the eye would come
// too near or too far for floats to tell it from the target, the camera stays as it is.
Camera dolly(const Camera& camera, double factor);

// Turns the picture about its middle: the angle is in radians, counter-clockwise.
Camera roll(const Camera& camera, double angle);

} // namespace raysteps
