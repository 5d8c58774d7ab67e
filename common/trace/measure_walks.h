#pragma once

#include "trace/trace_options.h"

namespace raysteps {

// --measure: what walks through these structures cost on the scene, as a table, and as the file of
// --json.
void measure_walks(const std::vector<std::string>& structures, const PictureOptions& picture,
                   const TraceOptions& tracing, const Scene& scene);

} // namespace raysteps
