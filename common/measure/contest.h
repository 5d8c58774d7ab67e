#pragma once

#include "compare/scene_result.h"
#include "embree/embree_part.h"
#include "gpu/limits.h"
#include "render/trace_rays.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

struct ContestRequest {
    std::vector<std::string> structures;
    std::map<std::string, std::string> build_values; // a builder takes those that it knows
    std::string triangle = "watertight";
    EmbreePart embree = EmbreePart::robust;
    int width = 128; // of the picture whose rays are traced
    int height = 128;
    int rounds = 5;            // after one that is not counted
    double most_seconds = 0.2; // of one trace; who takes longer is measured with fewer rays
};

// All structures, and Embree beside them, on the same rays (measure/ray_kinds.h) in the same
// rounds: each round has every contender once, so that what slows the machine for a while slows
// them all. A context must be current while it lives.
class Contest {
public:
    Contest(ContestRequest request, const Limits& limits);

    // Builds each structure of the scene once for all its walks, checks every answer against that
    // of bvh_ordered, counts visits and tests, and measures. Throws Error with exit code 1 where
    // answers differ; those of Embree, which rounds in another way, are only counted.
    SceneResult measure(const Scene& scene, const Progress& progress);

private:
    ContestRequest request_;
    Limits limits_;
    TraceRays judge_;
    std::map<std::string, TraceRays> walks_;
};

} // namespace raysteps
