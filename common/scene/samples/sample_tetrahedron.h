#pragma once

#include "scene/scene.h"

namespace raysteps {

// Sierpinski's tetrahedron, 4^(depth + 1) triangles: the "tetra" of Haines, "A proposal for
// standard graphics environments", 1987. The camera and the lights are left to be placed.
Scene sample_tetrahedron(int depth);

} // namespace raysteps
