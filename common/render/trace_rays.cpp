#include "render/trace_rays.h"

#include "error/error.h"
#include "gpu/draw.h"

#include <algorithm>
#include <limits>

namespace raysteps {

namespace {

// About a second of work for 512 x 512 rays on a small processor: progress can be shown, and no
// watchdog of a GPU's driver wakes up.
constexpr int usual_rounds_per_launch = 2048;

// The rays that a processor runs side by side may share one loop budget (Mesa's llvmpipe: 8 or 16
// rays), and each makes its rounds while the others wait.
constexpr int rays_side_by_side = 16;

// More launches than any walk through a structure needs; the loop over every triangle says itself
// how many it needs beyond. A walk that makes no progress is found out in minutes.
constexpr int most_launches = 1 << 14;

constexpr float farthest = std::numeric_limits<float>::max();

const std::string nobody = "observer/none.glsl";

Parts with_defaults(Parts parts) {
    parts.try_emplace("structure", "structure/every_triangle.glsl");
    parts.try_emplace("observer", nobody);
    return parts;
}

// What a launch leaves of each walk.
struct WalkTextures {
    WalkTextures(int width, int height, bool observed)
        : hits(TexelFormat::rgba32ui, width, height), places(TexelFormat::rgba32ui, width, height) {
        if (observed) {
            observations.emplace(TexelFormat::rgba32ui, width, height);
        }
    }

    std::vector<std::reference_wrapper<const Texture>> targets() const {
        std::vector<std::reference_wrapper<const Texture>> all{hits, places};
        if (observations) {
            all.emplace_back(*observations);
        }
        return all;
    }

    Texture hits;
    Texture places;
    std::optional<Texture> observations;
};

} // namespace

TraceRays::TraceRays(Parts parts, const Limits& limits)
    : TraceRays(std::move(parts),
                std::min(usual_rounds_per_launch, limits.loop_budget / rays_side_by_side)) {}

TraceRays::TraceRays(Parts parts, int rounds_per_launch)
    : trace_("pass/trace.frag", with_defaults(parts)),
      select_unfinished_("pass/select_unfinished.frag"), rounds_per_launch_(rounds_per_launch),
      observed_(parts.contains("observer") && parts.at("observer") != nobody) {}

Texture TraceRays::closest_hits(const RayTextures& rays, const SceneTextures& scene,
                                const LiveMask* live) {
    return trace(rays, scene, live, -farthest);
}

Texture TraceRays::any_hits(const RayTextures& rays, const SceneTextures& scene,
                            const LiveMask* live) {
    return trace(rays, scene, live, farthest);
}

Texture TraceRays::trace(const RayTextures& rays, const SceneTextures& scene, const LiveMask* live,
                         float near_enough) {
    const int width = rays.origins.width();
    const int height = rays.origins.height();
    WalkTextures last(width, height, observed_);
    WalkTextures next(width, height, observed_);
    trace_.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("triangle_corners", scene.corners)
        .set("near_enough", near_enough)
        .set("rounds", rounds_per_launch_);
    bind(trace_, scene.structure);
    std::optional<LiveMask> everywhere;
    const LiveMask& asked = live ? *live : everywhere.emplace(width, height);
    const double ray_count = static_cast<double>(width) * height;
    const int launches_allowed = most_launches + scene.structure.longest_walk / rounds_per_launch_;
    for (launches_ = 1; launches_ <= launches_allowed; ++launches_) {
        trace_.set("first_launch", launches_ == 1 ? 1 : 0)
            .set("last_hits", last.hits)
            .set("last_places", last.places);
        if (observed_) {
            trace_.set("last_observations", *last.observations);
        }
        draw(trace_, {.textures = next.targets(), .live = live});
        std::swap(last, next);
        select_unfinished_.set("places", last.places);
        const long unfinished = count_live(asked, select_unfinished_);
        if (unfinished == 0) {
            progress_(1.0);
            observations_ = std::move(last.observations);
            return std::move(last.hits);
        }
        const double rounds = static_cast<double>(launches_) * rounds_per_launch_;
        progress_(scene.structure.longest_walk > 0
                      ? rounds / scene.structure.longest_walk
                      : 1.0 - static_cast<double>(unfinished) / ray_count);
    }
    throw MachineError("This machine's OpenGL does not bring a walk to its end. Update the driver, "
                       "or try --context osmesa.");
}

} // namespace raysteps
