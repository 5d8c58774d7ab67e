#include "catch.h"
#include "render/generate_rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "structure/reach.h"
#include "support/expected_picture.h"
#include "support/gpu_hits.h"

#include <string>

using namespace raysteps;

// The program's default picture, at 256x256; the three other walks must paint it as well.
TEST_CASE("the picture of chapter 05 is the expected one by every walk", "[05][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("bunny", 1.0f);
    const BuiltStructure built =
        family_of("kd_restart")
            .build(scene.corners,
                   {.reach = reach_of(scene.camera.eye, scene.corners), .values = {}});
    const SceneTextures textures = upload(scene, built);
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    for (const std::string walk : {"kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"}) {
        CAPTURE(walk);
        TraceRays trace({{"triangle", "geometry/triangle_watertight.glsl"},
                         {"structure", "structure/" + walk + ".glsl"}},
                        measure_limits());
        const Image image = show_hits(rays, trace.closest_hits(rays, textures), textures,
                                      scene.camera, scene.background, "view/normals.glsl");
        CHECK(unexpected_pixels(image, "05_kd_tree") == 0);
    }
}
