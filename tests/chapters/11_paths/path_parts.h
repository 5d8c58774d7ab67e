#pragma once

#include "mirror/effects.h"

// The parts of chapter 11 as C++, with numbers of one kind each.
namespace raysteps::mirror {

// A part may ignore what its role offers.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"

struct PcgNumbers {
    using Observer = NoObserver;
    using Real = float;
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
#define uniform
#define precise
// clang-format off
#include "light/samples.glsl"
#include "light/path.glsl"
#include "light/hash.glsl"
#include "random/pcg.glsl"
#include "bounce/cosine.glsl"
#include "heuristic/power.glsl"
#include "roulette/by_weight.glsl"
#include "light/emitters.glsl"
// clang-format on
#undef uniform
#undef precise
};

struct SobolNumbers {
    using Observer = NoObserver;
    using Real = float;
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#include "mirror/parts.inc"
#define uniform
#define precise
// clang-format off
#include "light/samples.glsl"
#include "light/path.glsl"
#include "light/hash.glsl"
#include "random/sobol.glsl"
#include "bounce/uniform.glsl"
#include "heuristic/balance.glsl"
#include "roulette/none.glsl"
// clang-format on
#undef uniform
#undef precise
};

#pragma GCC diagnostic pop

} // namespace raysteps::mirror
