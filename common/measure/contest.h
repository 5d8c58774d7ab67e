#pragma once

#include "gpu/limits.h"
#include "measure/measure_structures.h"
#include "measure/ray_kinds.h"
#include "measure/statistics.h"
#include "reference/embree/embree.h"
#include "render/rays.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
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

// Neighbours in a run are as coherent as in the whole.
inline constexpr std::size_t rays_a_run = 64;

// Of each `step` runs of rays, the first: rays from all over the picture, for a contender that
// cannot trace them all in the time there is.
inline RayKind every_nth_run(const RayKind& kind, std::size_t step) {
    RayKind sample{kind.name, kind.query, {}};
    for (std::size_t begin = 0; begin < kind.rays.size(); begin += step * rays_a_run) {
        const std::size_t end = std::min(begin + rays_a_run, kind.rays.size());
        sample.rays.insert(sample.rays.end(),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(begin),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return sample;
}

// Rays of one kind, or a part of them, with the answers that all have to give.
struct RaySet {
    RayKind kind;
    RayTextures textures;
    std::vector<Hit> expected;
};

// The rays of one kind, and their samples, each made when it is asked for first.
class RaySets {
public:
    RaySets(RayKind kind, TraceRays& judge, const SceneTextures& scene)
        : kind_(std::move(kind)), judge_(judge), scene_(scene) {}

    const RayKind& whole() const { return kind_; }

    // Of each `step` runs of rays, one.
    const RaySet& sample(std::size_t step) {
        const auto known = sets_.find(step);
        if (known != sets_.end()) {
            return known->second;
        }
        RayKind kind = every_nth_run(kind_, step);
        RayTextures textures = upload_rays(kind.rays);
        std::vector<Hit> expected =
            read_hits(trace(judge_, scene_, textures, kind.query), kind.rays.size());
        return sets_
            .emplace(step, RaySet{std::move(kind), std::move(textures), std::move(expected)})
            .first->second;
    }

private:
    RayKind kind_;
    TraceRays& judge_;
    const SceneTextures& scene_;
    std::map<std::size_t, RaySet> sets_;
};

// Who takes part in one scene, whatever it is made of.
struct Contender {
    std::string name;
    std::vector<Fact> facts;
    std::function<void(const RaySet&)> run;                    // to its end
    std::function<std::size_t(const RaySet&)> count_different; // answers
};

// A walk through its structure. All that is given must outlive it.
Contender make_contender(const std::string& structure, TraceRays& walk, const SceneTextures& scene);

// Embree by single rays and by packets; nobody where the part is none.
std::vector<Contender> make_embree(const Scene& scene, EmbreePart part);

} // namespace raysteps
