#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// How a ray gets off the surface that it starts on (the parts of the slot <offset>). Rays leave a
// sphere of triangles outwards, and must hit the shell around it: one that meets the sphere again
// makes acne, one that is beyond the shell from the start makes a leak. The same sphere stands in
// several units, and once far from zero. The error is how far the origin was moved off its point. A
// context must be current.
Knob offset_knob(const Effort& effort);

} // namespace raysteps
