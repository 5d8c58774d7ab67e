#pragma once

#include "basics/statistics.h"
#include "gpu/limits.h"
#include "gpu/shaders.h"
#include "reference/embree/embree.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// Million rays per second over the rounds of a contest.
using Rate = MeasuredRange;

// Whether every round of a was faster than every round of b. Where neither is faster than the other
// in this sense, their ranges overlap, and no winner is named.
inline bool is_faster(const Rate& a, const Rate& b) {
    return lies_below(b, a);
}

// What rays of one kind cost one contender in one scene.
struct RayCosts {
    std::string contender; // a structure, or Embree
    std::string kind;      // of the rays (measure/ray_kinds.h)
    std::size_t rays = 0;  // that were measured: of a slow contender a part of all
    std::size_t all_rays = 0;
    double visits_per_ray = 0.0; // of cells or nodes; of Embree unknown, 0
    double tests_per_ray = 0.0;  // of triangles
    Rate rate{};
    double cores = 0.0;        // time on CPUs over the time on the clock, median
    std::size_t different = 0; // answers other than the judge's: of Embree only
};

struct BuildCosts {
    std::string contender;
    std::vector<Fact> facts;
};

struct SceneCosts {
    std::string scene;
    int triangles = 0;
    std::vector<BuildCosts> builds{}; // one per contender
    std::vector<RayCosts> rays{};     // kind by kind, in the order of the builds
};

inline const std::string embree_single = "Embree rtcIntersect1";
inline const std::string embree_packets = "Embree packets of 8";

inline bool is_embree(const std::string& contender) {
    return contender == embree_single || contender == embree_packets;
}

// The fact of that name, or 0 where nobody measured it.
double fact_of(const BuildCosts& build, const std::string& name);

// Our fastest walk for rays of that kind; null where there is none.
const RayCosts* fastest_walk(const SceneCosts& costs, const std::string& kind);

// Rays per second of our fastest walk over those of Embree by single rays: by the clock, and by
// processor time, whoever else had the other processors.
struct EmbreeRatio {
    double by_clock = 0.0;
    double by_cpu = 0.0;
};

// Nothing where Embree took no part, or none of our walks.
std::optional<EmbreeRatio> ratio_to_embree(const SceneCosts& costs, const std::string& kind);

struct MeasureRequest {
    std::vector<std::string> structures;
    std::map<std::string, std::string> build_values; // a builder takes those that it knows
    std::string triangle = "watertight";
    std::vector<std::string> kinds{"primary", "shadow", "bounce"};
    EmbreePart embree = EmbreePart::none;
    std::string judge{}; // the structure whose answers count; the first one where none is named
    int width = 256;     // of the picture whose rays are traced
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

    // Builds each structure of the scene once for all its walks, checks every answer against those
    // of the judge, counts visits and tests, and measures. Closest hits must agree in every bit; of
    // any hit, only whether there is one is compared. Throws Error with exit code 1 where answers
    // differ: with a triangle test that is not exact, that can happen. Embree's, which rounds in
    // another way, are only counted.
    SceneCosts measure(const Scene& scene, const Progress& progress);

private:
    MeasureRequest request_;
    Limits limits_;
    TraceRays judge_;
    std::map<std::string, TraceRays> walks_;
};

// A table for people: one row per structure and kind of rays.
std::string to_table(const SceneCosts& costs);

} // namespace raysteps
