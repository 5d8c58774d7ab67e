#pragma once

#include "gpu/context.h"
#include "render/trace_rays.h"
#include "scene/mesh.h"

#include <string>
#include <vector>

namespace raysteps {

// A scene of one mesh in grey.
inline Scene scene_of(const Mesh& mesh) {
    return add_mesh(Scene{}, mesh, Material{});
}

// The hits that the GPU finds with the triangle test of that name. A context must be current.
inline std::vector<Hit> gpu_hits(const Scene& scene, std::span<const Ray> rays,
                                 const std::string& triangle, int triangles_per_launch = 2048) {
    TraceRays trace({{"triangle", "geometry/triangle_" + triangle + ".glsl"}},
                    triangles_per_launch);
    const SceneTextures textures = upload(scene);
    return read_hits(trace.closest_hits(upload_rays(rays), textures), rays.size());
}

} // namespace raysteps
