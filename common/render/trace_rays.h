#pragma once

#include "gpu/limits.h"
#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "render/ray_textures.h"
#include "render/scene_textures.h"

#include <functional>

namespace raysteps {

// Called while a long trace goes on, with the part that is done, 0 to 1.
using Progress = std::function<void(double part_done)>;

// The intersection kernel, over every triangle of a scene. A launch tests as many triangles as the
// platform's loops can bear; each launch goes on from the hits of the one before, in two textures
// that change places. A launch that was cut short all the same is done again with half the
// triangles.
class TraceRays {
public:
    // The parts fill the slots <triangle>, <structure> and <observer> of pass/trace.frag; an
    // observer that nobody names is nobody, and a structure that nobody names is every_triangle.
    TraceRays(Parts parts, const Limits& limits);

    // For tests: launches that begin with this many triangles, however many the loops can bear.
    TraceRays(Parts parts, int triangles_per_launch);

    // A texture of hits as layout/hit_texel.glsl has them. Where a mask is given, only its live
    // pixels are traced, and the others hold nothing of meaning.
    Texture closest_hits(const RayTextures& rays, const SceneTextures& scene,
                         const LiveMask* live = nullptr);
    Texture any_hits(const RayTextures& rays, const SceneTextures& scene,
                     const LiveMask* live = nullptr);

    void report_progress(Progress progress) { progress_ = std::move(progress); }

private:
    Texture trace(const RayTextures& rays, const SceneTextures& scene, const LiveMask* live,
                  float near_enough);

    Program start_;
    Program trace_;
    Program select_unfinished_;
    int triangles_per_launch_;
    Progress progress_ = [](double) {};
};

} // namespace raysteps
