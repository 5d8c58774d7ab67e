#pragma once

#include "scene/scene.h"

namespace raysteps {

// A globe, a box and a floor with pictures on them (made by code), before a wall of bricks.
Scene sample_pictures();

} // namespace raysteps
