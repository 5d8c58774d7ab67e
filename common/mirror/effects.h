#pragma once

#include "mirror/glsl_language.h"

#include <glm/trigonometric.hpp>

namespace raysteps::mirror {

using glm::cos;
using glm::log2;
using glm::pow;
using glm::sin;
using uint = unsigned;

// The parts of chapter 09 as members, over the loop over every triangle.
template <class Real>
struct EffectParts {
#define TRIANGLE_PART "geometry/triangle_watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
#define uniform
#define precise
// clang-format off
#include "geometry/samples.glsl"
#include "geometry/lens.glsl"
#include "layout/glass.glsl"
#include "layout/media.glsl"
#include "layout/gloss.glsl"
#include "layout/pictures.glsl"
#include "layout/sky.glsl"
#include "shading/sky.glsl"
#include "shading/fresnel.glsl"
#include "shading/glass.glsl"
#include "shading/absorption.glsl"
#include "shading/highlight.glsl"
#include "shading/picture.glsl"
// clang-format on
#undef uniform
#undef precise
};

} // namespace raysteps::mirror
