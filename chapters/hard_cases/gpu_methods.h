#pragma once

#include "gpu/limits.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The same methods on the GPU; each program is compiled when it is asked for first. A context must
// be current for as long as this lives.
class GpuMethods {
public:
    explicit GpuMethods(const Limits& limits) : limits_(limits) {}

    // The nearest hits, with a triangle test and a structure by their names.
    std::vector<Hit> trace(const std::string& triangle, const std::string& structure,
                           const SceneTextures& scene, const RayTextures& rays, std::size_t count);

    const Limits& limits() const { return limits_; }

private:
    Limits limits_;
    std::map<std::string, TraceRays> tracers_;
};

} // namespace raysteps
