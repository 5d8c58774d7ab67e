#pragma once

#include "report/measured_range.h"
#include "structure/structure_family.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raysteps {

// Million rays a second over the rounds of a measurement.
using Rate = MeasuredRange;

// Whether every round of a was faster than every round of b. Where neither is faster than the other
// in this sense, their ranges overlap, and no winner is named.
inline bool is_faster(const Rate& a, const Rate& b) {
    return lies_below(b, a);
}

// What rays of one kind cost one contender in one scene.
struct ContestRow {
    std::string contender; // a structure, or Embree
    std::string kind;      // of the rays (measure/ray_kinds.h)
    std::size_t rays = 0;  // that were measured: of a slow contender a part of all
    std::size_t all_rays = 0;
    double visits_a_ray = 0.0; // of cells or nodes; of Embree unknown, 0
    double tests_a_ray = 0.0;
    Rate rate{};
    double cores = 0.0;        // the process's time on CPUs over the time on the clock, median
    std::size_t different = 0; // answers other than ours: of Embree only
};

struct ContestBuild {
    std::string contender;
    std::vector<Fact> facts;
};

struct SceneResult {
    std::string scene;
    int triangles = 0;
    std::vector<ContestBuild> builds{};
    std::vector<ContestRow> rows{};
};

inline const std::string embree_single = "Embree rtcIntersect1";
inline const std::string embree_packets = "Embree packets of 8";

inline bool is_embree(const std::string& contender) {
    return contender == embree_single || contender == embree_packets;
}

// The fact of that name, or 0 where nobody measured it.
inline double fact_of(const ContestBuild& build, const std::string& name) {
    for (const Fact& fact : build.facts) {
        if (fact.name == name) {
            return fact.value;
        }
    }
    return 0.0;
}

} // namespace raysteps
