#pragma once

#include "gpu/limits.h"
#include "gpu/shaders.h"
#include "measure/built_structures.h"
#include "measure/scene_costs.h"
#include "reference/embree/embree.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

struct MeasureRequest {
    std::vector<StructureChoice> structures;
    std::map<std::string, std::string> build_values; // a builder takes those that it knows
    std::string triangle = "watertight";
    std::vector<std::string> kinds{"primary", "shadow", "bounce"};
    EmbreePart embree = EmbreePart::none;
    // The walk whose hits all other rays start from; the first structure where none is named. It
    // answers for all rays where none of the structures can afford to.
    std::string first_walk{};
    int width = 256; // of the picture whose rays are traced
    int height = 256;
    int rounds = 5; // after one that is dropped
    // A contender that takes longer to trace all rays is measured with a part of them.
    double most_seconds = std::numeric_limits<double>::infinity();
};

// Structures, and Embree beside them, in contests on the same rays, scene by scene. A context must
// be current while it lives.
class StructureContest {
public:
    StructureContest(MeasureRequest request, const Limits& limits);

    // Builds each structure of the scene once for all its walks, lets them judge each other and the
    // loop over every triangle judge them (measure/judge.h), counts visits and tests, and measures.
    // Throws DisputeError where answers differ: with a triangle test that is not exact, that can
    // happen. Embree's, which rounds in another way, are only counted.
    SceneCosts measure(const Scene& scene, const Progress& progress);

private:
    MeasureRequest request_;
    Limits limits_;
    TraceRays first_walk_;
    TraceRays loop_;
    std::map<std::string, TraceRays> walks_; // by the name of the structure
};

} // namespace raysteps
