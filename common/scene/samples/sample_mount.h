#pragma once

#include "scene/scene.h"

namespace raysteps {

// A mountain of 2 * 4^depth triangles under four mirrors, which are balls of 1,280 triangles: the
// "mount" of Haines, "A proposal for standard graphics environments", 1987, with mirrors for glass.
Scene sample_mount(int depth);

} // namespace raysteps
