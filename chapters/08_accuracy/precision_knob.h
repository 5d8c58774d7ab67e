#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// A whole kernel, the walk through a hierarchy and its triangle test, in single and in double
// precision. Rays, boxes and triangles are floats in both. A context must be current.
Knob precision_knob(const Effort& effort);

} // namespace raysteps
