#include "render/trace_rays.h"

#include "error/error.h"
#include "gpu/draw.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace raysteps {

namespace {

// About a second of work for 512 x 512 rays on a small processor: progress can be shown, and no
// watchdog of a GPU's driver wakes up.
constexpr int usual_triangles_per_launch = 2048;

constexpr float farthest = std::numeric_limits<float>::max();

Parts with_defaults(Parts parts) {
    parts.try_emplace("structure", "structure/every_triangle.glsl");
    parts.try_emplace("observer", "observer/none.glsl");
    return parts;
}

} // namespace

TraceRays::TraceRays(Parts parts, const Limits& limits)
    : TraceRays(std::move(parts), std::min(usual_triangles_per_launch, limits.loop_budget / 2)) {}

TraceRays::TraceRays(Parts parts, int triangles_per_launch)
    : start_("pass/start_hits.frag"), trace_("pass/trace.frag", with_defaults(std::move(parts))),
      select_unfinished_("pass/select_unfinished.frag"),
      triangles_per_launch_(triangles_per_launch) {}

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
    Texture last(TexelFormat::rgba32ui, width, height);
    Texture next(TexelFormat::rgba32ui, width, height);
    start_.set("ray_origins", rays.origins).set("ray_directions", rays.directions);
    draw(start_, {.textures = {last}, .live = live});

    trace_.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("triangle_corners", scene.corners)
        .set("near_enough", near_enough);
    std::optional<LiveMask> everywhere;
    const LiveMask& asked = live ? *live : everywhere.emplace(width, height);
    int step = triangles_per_launch_;
    int first = 0;
    while (first < scene.triangle_count) {
        const int end = first + std::min(step, scene.triangle_count - first);
        trace_.set("last_hits", last).set("first_triangle", first).set("end_triangle", end);
        draw(trace_, {.textures = {next}, .live = live});
        select_unfinished_.set("hits", next);
        if (count_live(asked, select_unfinished_) > 0) {
            if (step == 1) {
                throw MachineError("This machine's OpenGL does not finish a test of one triangle. "
                                   "Update the driver, or try --context osmesa.");
            }
            step /= 2;
            continue;
        }
        std::swap(last, next);
        first = end;
        progress_(static_cast<double>(first) / scene.triangle_count);
    }
    return last;
}

} // namespace raysteps
