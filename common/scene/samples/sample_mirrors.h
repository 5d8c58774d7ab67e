#pragma once

#include "scene/scene.h"

namespace raysteps {

// Mirror balls and a tall mirror among coloured solids on a checkered floor, under two lights:
// 1,492 triangles, few enough to test every one of them for every ray. The mirrors see each other.
Scene sample_mirrors();

} // namespace raysteps
