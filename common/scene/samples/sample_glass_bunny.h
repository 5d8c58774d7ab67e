#pragma once

#include "scene/scene.h"

namespace raysteps {

// The Stanford bunny of green glass on a checkered floor under a sky. Throws InputError where the
// package with the bunny is not installed.
Scene sample_glass_bunny();

} // namespace raysteps
