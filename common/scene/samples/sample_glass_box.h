#pragma once

#include "scene/scene.h"

namespace raysteps {

// A box after the Cornell box with a mirror ball and a glass ball in it, under a lamp with an area:
// it calls for most effects.
Scene sample_glass_box();

} // namespace raysteps
