#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// What a picture costs and how wrong it is, by pictures of sample scenes; contexts must be current.

// Rays a pixel: 1, 4, 9 ... in a square; the truth has twice as many along each side as the most.
Knob samples_knob(const Effort& effort);

// How many mirrors a path follows.
Knob depth_knob(const Effort& effort);

// Points that stand for a lamp with an area: 1, 4, 16; the truth has 64.
Knob lamp_knob(const Effort& effort);

} // namespace raysteps
