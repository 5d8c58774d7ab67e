#pragma once

#include "program/command.h"
#include "render/trace_rays.h"

namespace raysteps {

// Rays against a scene, with a clock beside them and progress on the terminal. The command and the
// scene must outlive it.
class TimedTrace {
public:
    TimedTrace(const Command& command, const Parts& parts, const SceneTextures& scene);

    // The count is that of the rays: textures may hold empty ones behind them.
    Texture closest_hits(const RayTextures& rays, std::size_t ray_count);

    // What the observer saw of the last trace; nothing where nobody observes.
    const std::optional<Texture>& observations() const { return trace_.observations(); }

    // Prints how many rays (and of the loop over every triangle, tests) a second the last trace
    // made, and writes the numbers of --json.
    void report() const;

private:
    const Command& command_;
    const SceneTextures& scene_;
    TraceRays trace_;
    double rays_ = 0.0;
    double seconds_ = 0.0;
};

// Traces the file of --rays, writes that of --hits, and reports.
void trace_ray_file(const Command& command, const Parts& parts, const Scene& scene);

} // namespace raysteps
