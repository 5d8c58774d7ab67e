#pragma once

#include "mirror/glsl_language.h"

namespace raysteps::mirror {

// The loop over every triangle with the triangle tests that are there to be compared with.

template <class Real>
struct EveryTriangleRounded {
#define TRIANGLE_PART "triangle/watertight_rounded.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct EveryTrianglePaperRepaired {
#define TRIANGLE_PART "triangle/paper_repaired.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct EveryTrianglePaperCulling {
#define TRIANGLE_PART "triangle/paper_culling.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct EveryTrianglePaperTwoSided {
#define TRIANGLE_PART "triangle/paper_two_sided.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct EveryTrianglePaperWrongDepth {
#define TRIANGLE_PART "triangle/paper_wrong_depth.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
};

} // namespace raysteps::mirror
