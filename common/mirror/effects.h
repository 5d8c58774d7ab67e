#pragma once

#include "mirror/walks.h"

#include <glm/trigonometric.hpp>

namespace raysteps::mirror {

using glm::cos;
using glm::log2;
using glm::pow;
using glm::sin;

// The parts of chapter 09 as members, over the loop over every triangle.
template <class Real>
struct EffectParts {
    using Observer = NoObserver;
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
#define uniform
#define precise
// clang-format off
#include "light/samples.glsl"
#include "light/lens.glsl"
#include "light/glass_materials.glsl"
#include "light/media.glsl"
#include "light/highlight.glsl"
#include "light/texture.glsl"
#include "light/normal_map.glsl"
#include "light/sky.glsl"
#include "light/fresnel.glsl"
#include "light/glass.glsl"
#include "light/absorption.glsl"
// clang-format on
#undef uniform
#undef precise
};

} // namespace raysteps::mirror
