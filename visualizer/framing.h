#pragma once

#include "stage.h"

namespace raysteps::view {

// A camera that sees the whole scene, as large as fits below a title; from the side of the ray, if
// there is one.
Camera frame_stage(const Stage& stage, double aspect_ratio);

// The state's viewpoint, or by default that of frame_stage, moved close to what the state asks
// about: the triangle that is missed with the box that left it out, the selected cell, or the
// step's. That then fills a third of the picture. Not moved where there is none of them.
Camera fly_to_step(const Stage& stage, const State& state);

// The longest side of the box; never 0.
float size_of(const Box& bounds);

} // namespace raysteps::view
