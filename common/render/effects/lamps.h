#pragma once

#include "render/effects/effect_buffers.h"
#include "render/effects/ray_list.h"
#include "gpu/live_mask.h"
#include "render/trace_rays.h"

#include <optional>
#include <vector>

namespace raysteps {

// Where the live paths of a picture are: their rays, what these hit, and what they count.
struct PathsAtHits {
    const RayTextures& rays;
    const Texture& hits;
    const Texture& weights;
    const LiveMask& live;
};

// Adds the light of the scene's lamps to a picture, with the effects of the plan. Lights are asked
// one after the other, so each pixel gets its sums in the same order whatever the plan.
class Lamps {
public:
    Lamps(std::vector<Light> lights, const Plan& plan);

    // Of all paths at once. `sample` is that of the camera's rays.
    void light(const PathsAtHits& paths, const Texture& color, int sample, PlannedPasses& passes,
               TraceRays& trace, const SceneTextures& scene, RayTally& tally) const;

private:
    std::vector<Light> lights_;
    Plan plan_;
};

} // namespace raysteps
