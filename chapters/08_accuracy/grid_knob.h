#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// How a walk through a grid knows where the next plane is: from the index of the plane, or by
// adding up. A ray that visits other cells than it goes through is a fault, and so is a hit that
// gets lost. A context must be current.
Knob grid_knob(const Effort& effort);

} // namespace raysteps
