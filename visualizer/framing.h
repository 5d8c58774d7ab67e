#pragma once

#include "stage.h"

namespace raysteps::view {

// A camera that sees the whole scene, as large as it fits below a title; where there is a ray, from
// the side.
Camera frame_stage(const Stage& stage, double aspect_ratio);

// The same camera, moved near to the state's step: its box fills a third of the picture. The one
// given where there is no step.
Camera fly_to_step(const Stage& stage, const State& state, const Camera& from);

// The largest side of what is seen; never 0.
float size_of(const Box& bounds);

} // namespace raysteps::view
