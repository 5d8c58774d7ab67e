#pragma once

#include "basics/timed.h"
#include "gpu/shaders.h"
#include "program/figures.h"
#include "program/show.h"
#include "render/rays.h"
#include "render/trace_rays.h"
#include "trace/trace_options.h"

#include <string>

namespace raysteps {

// The parts of these names; for a heat map, with the observer that counts what the walks do.
// Throws InputError where there is no such part.
Parts trace_parts(const std::string& triangle, const std::string& structure,
                  const std::string& view = "");

// Whether the view is a heat map of what the walks did: visits (of cells or nodes) or tests (of
// triangles).
bool is_heat_map(const std::string& view);

// That heat map, from what the observer counted.
Image show_work(const Texture& observations, const std::string& view, const std::string& structure);

// Rays that were traced, and the seconds that it took.
struct TraceTime {
    double rays = 0.0;
    double seconds = 0.0;
};

// Prints how many rays (and of the loop over every triangle, tests) a second that is, and writes
// the numbers of --json.
void report_trace(const PictureOptions& picture, const TraceOptions& tracing, const Scene& scene,
                  const SceneTextures& textures, const TraceTime& time);

// The head of what --json writes of one scene and one structure.
FiguresHead head_of(const std::string& schema, const TraceOptions& tracing, const Scene& scene);

// What a builder found out, by name.
Numbers numbers_of(const std::vector<Fact>& facts);

// Traces the file of --rays, writes that of --hits, and reports.
void trace_ray_file(const PictureOptions& picture, const TraceOptions& tracing, const Scene& scene);

} // namespace raysteps
