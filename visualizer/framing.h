#pragma once

#include "stage.h"

namespace raysteps::view {

// A camera that sees the whole scene, as large as fits below a title; from the side of the ray, if
// there is one.
Camera frame_stage(const Stage& stage, double aspect_ratio);

// The camera moved close to the state's step, whose box then fills a third of the picture;
// unchanged where there is no step.
Camera fly_to_step(const Stage& stage, const State& state, const Camera& from);

// The longest side of the box; never 0.
float size_of(const Box& bounds);

} // namespace raysteps::view
