#pragma once

#include "mirror/glsl_language.h"

namespace raysteps::mirror {

// The loop over every triangle, in single or double precision, with one triangle test each.

template <class Real>
struct EveryTriangleWatertight {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct EveryTriangleMoellerTrumbore {
#define TRIANGLE_PART "triangle/moeller_trumbore.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

} // namespace raysteps::mirror
