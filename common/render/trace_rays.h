#pragma once

#include "gpu/limits.h"
#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "render/rays.h"
#include "render/scene_textures.h"

#include <functional>
#include <optional>

namespace raysteps {

// Called while a long trace goes on, with the part that is done, 0 to 1.
using Progress = std::function<void(double part_done)>;

// The traversal and intersection kernel, launched as often as the longest walk needs: a launch
// makes as many rounds as the platform's loops can bear, and keeps the hit and the position of each
// walk in textures, where the next one takes them up. Two sets of textures take turns. Source: Wang
// and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010.
class TraceRays {
public:
    // The parts fill the slots <triangle>, <structure> and <observer> of pass/trace/trace.frag;
    // where no observer is given nobody observes, and where no structure is given, it is
    // every_triangle.
    TraceRays(Parts parts, const Limits& limits);

    // For tests: launches of that many rounds, whatever the limits say.
    TraceRays(Parts parts, int rounds_per_launch);

    // A texture of hits as core/texels.glsl has them. Where a mask is given, only its live
    // pixels are traced, and the others hold nothing of meaning.
    Texture closest_hits(const RayTextures& rays, const SceneTextures& scene,
                         const LiveMask* live = nullptr);
    Texture any_hits(const RayTextures& rays, const SceneTextures& scene,
                     const LiveMask* live = nullptr);

    // What the observer saw of the last trace: one texel per ray, as the file of the observer says.
    // Nothing where nobody observes.
    const std::optional<Texture>& observations() const { return observations_; }

    // How many launches the last trace took.
    int launch_count() const { return launches_; }

    void report_progress(Progress progress) { progress_ = std::move(progress); }

private:
    Texture trace(const RayTextures& rays, const SceneTextures& scene, const LiveMask* live,
                  float near_enough);
    Texture take_places(int width, int height);
    const LiveMask& everywhere(int width, int height);

    Program trace_;
    Program select_unfinished_;
    int rounds_per_launch_;
    bool observed_;
    std::optional<Texture> observations_;
    // Kept from trace to trace, since memory that is new costs more than a pass over it.
    std::optional<Texture> spare_places_;
    std::optional<LiveMask> everywhere_;
    Texture nothing_{TexelFormat::rgba32ui, 1, 1}; // what the first launch is given as the last one
    int launches_ = 0;
    Progress progress_ = [](double) {};
};

} // namespace raysteps
