#include "measure/scene_costs.h"

#include <fmt/core.h>

namespace raysteps {

double fact_of(const BuildCosts& build, const std::string& name) {
    const auto fact = std::find_if(build.facts.begin(), build.facts.end(),
                                   [&](const Fact& one) { return one.name == name; });
    return fact == build.facts.end() ? 0.0 : fact->value;
}

const RayCosts* fastest_walk(const SceneCosts& costs, const std::string& kind) {
    const RayCosts* fastest = nullptr;
    for (const RayCosts& rays : costs.rays) {
        if (rays.kind == kind && !is_embree(rays.contender) &&
            (fastest == nullptr || rays.rate.median > fastest->rate.median)) {
            fastest = &rays;
        }
    }
    return fastest;
}

std::optional<EmbreeRatio> ratio_to_embree(const SceneCosts& costs, const std::string& kind) {
    const RayCosts* const ours = fastest_walk(costs, kind);
    const auto embree = std::ranges::find_if(costs.rays, [&](const RayCosts& rays) {
        return rays.kind == kind && rays.contender == embree_single;
    });
    if (ours == nullptr || embree == costs.rays.end()) {
        return std::nullopt;
    }
    const double ratio = ours->rate.median / embree->rate.median;
    return EmbreeRatio{ratio, ratio * embree->cores / ours->cores};
}

std::string to_table(const SceneCosts& costs) {
    std::string table =
        "structure        rays        visits/ray  tests/ray  million rays/s (range)\n";
    for (const BuildCosts& build : costs.builds) {
        for (const RayCosts& rays : costs.rays) {
            if (rays.contender == build.contender) {
                table +=
                    fmt::format("{:16} {:10} {:11.2f} {:10.2f}  {:.3g} ({:.3g} to {:.3g})\n",
                                rays.contender, rays.kind, rays.visits_per_ray, rays.tests_per_ray,
                                rays.rate.median, rays.rate.lowest, rays.rate.highest);
            }
        }
    }
    return table;
}

} // namespace raysteps
