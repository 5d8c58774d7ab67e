#pragma once

#include "scene/scene.h"

namespace raysteps {

// A knot of 1,024 * size * size triangles, a few decimetres wide, on the pitch of a stadium that is
// 200 metres long and has 2,152 triangles: the "teapot in a stadium" of Haines (Ray Tracing News),
// which a uniform grid cannot resolve. In metres. The camera stands before the knot.
Scene sample_stadium(int size);

} // namespace raysteps
