#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// Tests of a ray against a box (the parts of the slot <slab>), on rays aimed at corners of the
// boxes and along their sides. A miss of a box that the ray truly meets, by exact arithmetic, is a
// fault; a visit in vain is none, and is counted by itself. A context must be current.
Knob slab_knob(const Effort& effort);

} // namespace raysteps
