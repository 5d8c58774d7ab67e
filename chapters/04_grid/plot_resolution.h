#pragma once

#include "trace/trace_options.h"

namespace raysteps {

// Builds grids from 1 to 256 cells along the longest side, traces the scene's primary rays through
// each, and plots visits, tests and time a ray against the resolution: NAME_resolution.png in the
// folder of --out. A context must be current.
void plot_resolution(const PictureOptions& picture, const TraceOptions& tracing,
                     const Scene& scene);

} // namespace raysteps
