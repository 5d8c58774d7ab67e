#pragma once

#include "scene/scene.h"

namespace raysteps {

// Matte solids under one wide lamp: shadows that grow softer with the distance.
Scene sample_soft_light();

} // namespace raysteps
