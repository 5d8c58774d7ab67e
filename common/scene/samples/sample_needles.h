#pragma once

#include "scene/scene.h"

namespace raysteps {

// `count` long thin triangles in all directions through the cube from -1 to 1: 50 to 5,000 times as
// long as they are wide, so that their boxes are nearly empty. The same seed gives the same bits on
// every machine. The camera and the lights are left to be placed.
Scene sample_needles(int count, int seed);

} // namespace raysteps
