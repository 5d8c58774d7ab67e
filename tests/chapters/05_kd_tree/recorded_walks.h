#pragma once

#include "mirror/kd_tree.h"

#include <vector>

namespace raysteps::mirror {

// The walks through a kd-tree with somebody who writes down where they come.

template <class Real>
struct RecordedRestart {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_restart.glsl"
#define OBSERVER_PART "chapters/05_kd_tree/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct RecordedBacktrack {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_backtrack.glsl"
#define OBSERVER_PART "chapters/05_kd_tree/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct RecordedShortStack {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_short_stack.glsl"
#define OBSERVER_PART "chapters/05_kd_tree/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct RecordedRopes {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_ropes.glsl"
#define OBSERVER_PART "chapters/05_kd_tree/recorder.inc"
#include "mirror/parts.inc"
};

} // namespace raysteps::mirror
