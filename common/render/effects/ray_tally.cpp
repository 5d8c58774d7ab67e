#include "effects/ray_tally.h"

namespace raysteps {

std::vector<std::pair<std::string, long>> kinds_of(const RayTally& tally) {
    return {{"camera", tally.camera},
            {"shadow", tally.shadow},
            {"soft shadow", tally.soft_shadow},
            {"shadow behind glass", tally.behind_glass},
            {"mirror", tally.mirror},
            {"refracted", tally.refracted},
            {"reflected by glass", tally.reflected_by_glass}};
}

long all_rays(const RayTally& tally) {
    long all = 0;
    for (const auto& [kind, count] : kinds_of(tally)) {
        all += count;
    }
    return all;
}

} // namespace raysteps
