#pragma once

#include "scene/scene.h"

namespace raysteps {

// An interior that calls for every effect but the lens: a table with glass on it before a wall of
// bricks, a mirror, a window to the sky, and a lamp with an area.
Scene sample_room();

} // namespace raysteps
