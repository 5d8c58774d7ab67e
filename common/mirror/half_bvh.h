#pragma once

#include "mirror/glsl_language.h"

namespace raysteps::mirror {

// The walk through a BVH with boxes of half precision; its structure comes packed
// (mirror/packed_mirror.h).

template <class Real>
struct HalfBvh {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/half_bvh.glsl"
#include "mirror/parts.inc"
};

} // namespace raysteps::mirror
