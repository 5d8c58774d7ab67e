#pragma once

#include "effort.h"
#include "knob.h"

namespace raysteps {

// Where the rays of a picture come from: interpolated by the rasterizer as in the paper, or
// computed by each pixel. The error is that of the direction (reference/reference_ray.h), in ulp.
// A context must be current.
Knob primary_knob(const Effort& effort);

} // namespace raysteps
