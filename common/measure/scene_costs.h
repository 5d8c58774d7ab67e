#pragma once

#include "basics/statistics.h"
#include "structure/structure.h"

#include <algorithm>
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
    Rate cpu_rate{};    // per second of processor time, all threads together
    double cores = 0.0; // time on CPUs over the time on the clock, median
    // Over the rate of Embree by single rays, round by round, so that what slows the machine for a
    // while slows both: by processor time, but by the clock where OpenGL has a GPU. Of our walks
    // where Embree took part.
    std::optional<MeasuredRange> to_embree{};
    std::size_t different = 0; // answers other than our walks': of Embree only
    std::size_t judged = 0;    // rays that the loop over every triangle traced too: of our walks
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

// The part of the rays of which that many may be wrong, with 95 % confidence, where a random sample
// of n has no wrong one: 3 / n. Source: B. D. Jovanovic and P. S. Levy, "A Look at the Rule of
// Three", The American Statistician 51, 1997.
inline double bound_of_wrong(std::size_t judged) {
    return judged == 0 ? 1.0 : std::min(1.0, 3.0 / static_cast<double>(judged));
}

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

// A table for people: one row per structure and kind of rays.
std::string to_table(const SceneCosts& costs);

} // namespace raysteps
