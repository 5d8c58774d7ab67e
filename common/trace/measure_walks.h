#pragma once

#include "measure/measure_structures.h"
#include "program/output.h"
#include "trace/trace_options.h"

#include <filesystem>

namespace raysteps {

// StructureContest::measure. Where answers are disputed, prints who differs from whom, and writes
// the disputed rays to the folder, before it throws.
SceneCosts measure_or_dispute(StructureContest& contest, const Scene& scene,
                              const Progress& progress, const std::filesystem::path& folder);

// For programs: what each contender took to build, and kind by kind what its rays cost, with our
// best walk and its ratio to Embree by single rays where that took part
// (scene_costs.schema.json).
Numbers numbers_of(const SceneCosts& costs);

// What numbers_of was made of, but for the number of triangles. Throws InputError where it is
// something else.
SceneCosts scene_costs_of(const Numbers& numbers);

// --measure: what walks through these structures cost on the scene, as a table, and as the file of
// --json.
void measure_walks(const std::vector<std::string>& structures, const PictureOptions& picture,
                   const TraceOptions& tracing, const Scene& scene);

} // namespace raysteps
