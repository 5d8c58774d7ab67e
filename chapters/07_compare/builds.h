#pragma once

#include "basics/statistics.h"
#include "render/trace_rays.h"
#include "run_comparison.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <string>
#include <vector>

namespace raysteps {

// A BVH built by us and by Embree: nanoseconds of processor time per triangle.
struct BuildContest {
    std::string scene;
    std::size_t triangles = 0;
    MeasuredRange ours;
    MeasuredRange embrees;
    double cost_to_sweep = 0.0; // our tree's expected cost as a multiple of a full sweep's
};

// Builds the scene's tree with the options of the request and by Embree's rtcBuildBVH at medium
// quality in turn, each on one thread, for leaves as large and the same costs; after a round that
// is dropped. Throws MachineError where Embree is missing, and InputError where there is no
// triangle or an option makes no sense.
BuildContest contest_builds(const Scene& scene, const BuildRequest& request, int rounds,
                            const Progress& progress);

// For people, with the median, lowest and highest of the rounds; and for programs.
std::string to_table(const std::vector<BuildContest>& contests);
std::string to_csv(const std::vector<BuildContest>& contests);

// Builds a BVH of each scene in turn with Embree, prints the table, and writes builds.csv to the
// folder of --out, and the file of --json.
void run_builds(const PictureOptions& picture, const TraceOptions& tracing,
                const Comparison& comparison);

} // namespace raysteps
