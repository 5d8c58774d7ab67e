#pragma once

#include "scene/scene.h"

namespace raysteps {

// A dense knot of 1,024 * size * size triangles: every box around a part of it is full of others.
// The camera and the lights are left to be placed.
Scene sample_knot(int size);

} // namespace raysteps
