#include "gpu_methods.h"

namespace raysteps {

std::vector<Hit> GpuMethods::trace(const std::string& triangle, const std::string& structure,
                                   const SceneTextures& scene, const RayTextures& rays,
                                   std::size_t count) {
    const std::string name = triangle + " " + structure;
    auto tracer = tracers_.find(name);
    if (tracer == tracers_.end()) {
        tracer =
            tracers_
                .emplace(name, TraceRays(walk_parts(triangle, structure), limits_, Packets::always))
                .first;
    }
    return read_hits(tracer->second.closest_hits(rays, scene), count);
}

} // namespace raysteps
