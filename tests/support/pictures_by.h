#pragma once

#include "render/rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "gpu_hits.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

// The default picture of a chapter, at 256x256, by each of these walks through one structure that
// is built as the program builds it. By the names of the walks. A context must be current.
inline std::map<std::string, Image> pictures_by(const std::vector<std::string>& walks) {
    const Scene scene = load_scene("bunny", 1.0f);
    const BuiltStructure built =
        family_of(walks.front())
            .build(scene.corners,
                   {.reach = reach_of(scene.camera.eye, scene.corners), .values = {}});
    const SceneTextures textures = upload(scene, built);
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    std::map<std::string, Image> pictures;
    for (const std::string& walk : walks) {
        TraceRays trace({{"triangle", "triangle/watertight.glsl"},
                         {"structure", find_part("structure", walk)}},
                        measure_limits());
        pictures[walk] = show_hits(rays, trace.closest_hits(rays, textures), textures, scene.camera,
                                   scene.background, "view/normals.glsl");
    }
    return pictures;
}

} // namespace raysteps
