#pragma once

#include "scene/scene.h"

namespace raysteps {

// One compact object: a ball of 20 * size * size triangles of nearly equal size.
// The camera and the lights are left to be placed.
Scene sample_compact(int size);

} // namespace raysteps
