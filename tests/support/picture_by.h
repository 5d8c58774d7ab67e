#pragma once

#include "render/generate_rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "support/gpu_hits.h"

#include <string>

namespace raysteps {

// The default picture of a structure's chapter, at 256x256, by a structure built as the program
// builds it. A context must be current.
inline Image picture_by(const std::string& structure) {
    const Scene scene = load_scene("bunny", 1.0f);
    const BuiltStructure built = family_of(structure).build(
        scene.corners, {.reach = reach_of(scene.camera.eye, scene.corners), .values = {}});
    const SceneTextures textures = upload(scene, built);
    TraceRays trace({{"triangle", "geometry/triangle_watertight.glsl"},
                     {"structure", "structure/" + structure + ".glsl"}},
                    measure_limits());
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    return show_hits(rays, trace.closest_hits(rays, textures), textures, scene.camera,
                     scene.background, "view/normals.glsl");
}

} // namespace raysteps
