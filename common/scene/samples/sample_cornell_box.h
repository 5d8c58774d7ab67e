#pragma once

#include "scene/scene.h"

namespace raysteps {

// The Cornell box with its two blocks, in millimetres: the measured geometry, camera and
// reflectances of "Cornell Box Data", Program of Computer Graphics, Cornell University, 1998. 32
// triangles. The lamp hangs 0.8 mm under the ceiling, since it would coincide with it, and a point
// light is added under it; a dim one at the camera stands in for what the walls scatter. The blocks
// have no bottom, which would coincide with the floor.
Scene sample_cornell_box();

} // namespace raysteps
