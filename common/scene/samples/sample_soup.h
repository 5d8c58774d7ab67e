#pragma once

#include "scene/scene.h"

namespace raysteps {

// `count` random triangles in the cube from -1 to 1, as small as is needed to keep their density.
// The same seed gives the same bits on every machine. The camera and the lights are left to be
// placed.
Scene sample_soup(int count, int seed);

} // namespace raysteps
