#pragma once

#include "gpu_hits.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "trace/trace_picture.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

inline SceneTextures bunny_in_structure(const Scene& scene, const std::string& walk) {
    const BuiltStructure built = family_of(walk).build(
        scene.corners, {.reach = reach_of(origins_of(scene.camera), scene.corners), .values = {}});
    return upload(scene, built);
}

// The bunny's normals, at 256x256, by each of these walks through one structure that
// is built as the program builds it. By the names of the walks. A context must be current.
inline std::map<std::string, Image> pictures_by(const std::vector<std::string>& walks) {
    const Scene scene = load_scene("bunny", 1.0f);
    const SceneTextures textures = bunny_in_structure(scene, walks.front());
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    std::map<std::string, Image> pictures;
    for (const std::string& walk : walks) {
        TraceRays trace(trace_parts("watertight", walk), measure_limits());
        pictures[walk] = show_hits(rays, trace.closest_hits(rays, textures), textures, scene.camera,
                                   scene.background, "view/normals.glsl");
    }
    return pictures;
}

// The opening picture of the chapter of that walk, at 256x256: the heat map of its visits. A
// context must be current.
inline Image visits_by(const std::string& walk) {
    const Scene scene = load_scene("bunny", 1.0f);
    const SceneTextures textures = bunny_in_structure(scene, walk);
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    TraceRays trace(trace_parts("watertight", walk, "visits"), measure_limits());
    trace.closest_hits(rays, textures);
    return show_work(*trace.observations(), "visits", walk);
}

} // namespace raysteps
