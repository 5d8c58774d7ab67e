#pragma once

#include "gpu/context.h"
#include "gpu/shaders.h"
#include "render/trace_rays.h"
#include "scene_of.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <string>
#include <vector>

namespace raysteps {

// The hits that the GPU finds with the triangle test of that name. A context must be current.
inline std::vector<Hit> gpu_hits(const Scene& scene, std::span<const Ray> rays,
                                 const std::string& triangle, int rounds_per_launch = 2048) {
    TraceRays trace({{"triangle", find_part("triangle", triangle)}}, rounds_per_launch);
    const SceneTextures textures = upload(scene);
    return read_hits(trace.closest_hits(upload_rays(rays), textures), rays.size());
}

// The same with the watertight test and a structure, built for those rays with the values given.
inline std::vector<Hit> gpu_hits_of(const Scene& scene, std::span<const Ray> rays,
                                    const std::string& structure,
                                    const std::map<std::string, std::string>& values = {},
                                    int rounds_per_launch = 2048) {
    TraceRays trace({{"triangle", "triangle/watertight.glsl"},
                     {"structure", find_part("structure", structure)}},
                    rounds_per_launch);
    const BuiltStructure built =
        family_of(structure).build(scene.corners, {reach_of(rays, scene.corners), values});
    const SceneTextures textures = upload(scene, built);
    return read_hits(trace.closest_hits(upload_rays(rays), textures), rays.size());
}

} // namespace raysteps
