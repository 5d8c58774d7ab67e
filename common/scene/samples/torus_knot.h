#pragma once

#include "scene/mesh.h"

namespace raysteps {

// A tube along the torus knot that winds seven times around the torus' axis and sixteen times
// around its ring: 1,024 * size * size triangles. It fits in a box of about 4.1 * 4.1 * 1.6 around
// the origin.
Mesh torus_knot(int size);

} // namespace raysteps
