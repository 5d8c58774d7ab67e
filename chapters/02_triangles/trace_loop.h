#pragma once

#include "command/command.h"
#include "render/trace_rays.h"

namespace raysteps {

// The parts that --triangle asks for. Throws InputError.
Parts trace_parts(const Command& command);

// The loop over every triangle, with a clock beside it.
class TraceLoop {
public:
    TraceLoop(const Command& command, const Parts& parts, const SceneTextures& scene);

    Texture closest_hits(const RayTextures& rays);

    // Traces the file of --rays and writes that of --hits.
    void trace_ray_file();

    // Prints how many tests a second the last trace made, and writes the numbers of --json.
    void report() const;

private:
    const Command& command_;
    const SceneTextures& scene_;
    TraceRays trace_;
    double tests_ = 0.0;
    double seconds_ = 0.0;
};

} // namespace raysteps
