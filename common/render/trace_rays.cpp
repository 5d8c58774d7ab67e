#include "render/trace_rays.h"

#include "basics/error.h"
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

// This many launches in which no ray comes to its end mean that a walk is stuck. (A cell or leaf
// would have to list eight million triangles to need as many.)
constexpr int most_launches_in_vain = 1 << 12;

constexpr float farthest = std::numeric_limits<float>::max();

const std::string nobody = "observer/none.glsl";

Parts with_defaults(Parts parts) {
    parts.try_emplace("structure", "structure/every_triangle.glsl");
    parts.try_emplace("observer", nobody);
    return parts;
}

// What a launch leaves of each walk.
struct WalkTextures {
    Texture hits;
    Texture places;
    std::optional<Texture> observations;

    std::vector<std::reference_wrapper<const Texture>> targets() const {
        std::vector<std::reference_wrapper<const Texture>> all{hits, places};
        if (observations) {
            all.emplace_back(*observations);
        }
        return all;
    }
};

WalkTextures make_walk_textures(Texture places, bool observed) {
    const int width = places.width();
    const int height = places.height();
    WalkTextures textures{Texture(TexelFormat::rgba32ui, width, height), std::move(places), {}};
    if (observed) {
        textures.observations.emplace(TexelFormat::rgba32ui, width, height);
    }
    return textures;
}

} // namespace

TraceRays::TraceRays(Parts parts, const Limits& limits)
    : TraceRays(std::move(parts),
                std::min(usual_rounds_per_launch, limits.loop_budget / rays_side_by_side)) {}

TraceRays::TraceRays(Parts parts, int rounds_per_launch)
    : trace_("pass/trace/trace.frag", with_defaults(parts)),
      select_unfinished_("pass/select/select_unfinished.frag"),
      rounds_per_launch_(rounds_per_launch),
      observed_(parts.contains("observer") && parts.at("observer") != nobody) {}

Texture TraceRays::closest_hits(const RayTextures& rays, const SceneTextures& scene,
                                const LiveMask* live) {
    return trace(rays, scene, live, -farthest);
}

Texture TraceRays::any_hits(const RayTextures& rays, const SceneTextures& scene,
                            const LiveMask* live) {
    return trace(rays, scene, live, farthest);
}

Texture TraceRays::take_places(int width, int height) {
    if (spare_places_ && spare_places_->width() == width && spare_places_->height() == height) {
        Texture places = std::move(*spare_places_);
        spare_places_.reset();
        return places;
    }
    return {TexelFormat::rgba32ui, width, height};
}

const LiveMask& TraceRays::everywhere(int width, int height) {
    if (!everywhere_ || everywhere_->width() != width || everywhere_->height() != height) {
        everywhere_.emplace(width, height);
    }
    return *everywhere_;
}

Texture TraceRays::trace(const RayTextures& rays, const SceneTextures& scene, const LiveMask* live,
                         float near_enough) {
    const int width = rays.origins.width();
    const int height = rays.origins.height();
    std::optional<WalkTextures> last;
    WalkTextures next = make_walk_textures(take_places(width, height), observed_);
    trace_.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("triangle_corners", scene.corners)
        .set("near_enough", near_enough)
        .set("rounds", rounds_per_launch_);
    bind(trace_, scene.structure);
    const LiveMask& asked = live ? *live : everywhere(width, height);
    const double ray_count = static_cast<double>(width) * height;
    const int launches_of_longest = scene.structure.longest_walk / rounds_per_launch_;
    long last_unfinished = -1;
    int in_vain = 0;
    for (launches_ = 1; in_vain <= most_launches_in_vain + launches_of_longest; ++launches_) {
        trace_.set("first_launch", last ? 0 : 1)
            .set("last_hits", last ? last->hits : nothing_)
            .set("last_places", last ? last->places : nothing_)
            .set("last_observations", last && observed_ ? *last->observations : nothing_);
        draw(trace_, {.textures = next.targets(), .live = live});
        select_unfinished_.set("places", next.places);
        const long unfinished = count_live(asked, select_unfinished_);
        if (unfinished == 0) {
            progress_(1.0);
            observations_ = std::move(next.observations);
            spare_places_ = std::move(next.places);
            return std::move(next.hits);
        }
        if (!last) {
            last = make_walk_textures(take_places(width, height), observed_);
        }
        std::swap(*last, next);
        in_vain = unfinished == last_unfinished ? in_vain + 1 : 0;
        last_unfinished = unfinished;
        const double rounds = static_cast<double>(launches_) * rounds_per_launch_;
        progress_(scene.structure.longest_walk > 0
                      ? rounds / scene.structure.longest_walk
                      : 1.0 - static_cast<double>(unfinished) / ray_count);
    }
    throw MachineError("The walk of " + std::to_string(last_unfinished) +
                       " rays stands still after " + std::to_string(launches_ - 1) +
                       " launches. If a shader was edited, look there; else update the driver, or "
                       "try --context osmesa.");
}

} // namespace raysteps
