#pragma once

#include "scene/scene.h"

namespace raysteps {

// A row of balls that runs away from a camera with a wide lens: only the red one is sharp.
Scene sample_lens();

} // namespace raysteps
