#include "catch.h"
#include "render/generate_rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "structure/reach.h"
#include "support/expected_picture.h"
#include "support/gpu_hits.h"

#include <string>

using namespace raysteps;

// The program's default picture, at 256x256; the other walks must paint it as well.
TEST_CASE("the picture of chapter 06 is the expected one by every walk", "[06][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("bunny", 1.0f);
    const BuiltStructure built =
        family_of("bvh_ordered")
            .build(scene.corners,
                   {.reach = reach_of(scene.camera.eye, scene.corners), .values = {}});
    const SceneTextures textures = upload(scene, built);
    const RayTextures rays = generate_rays(scene.camera, 256, 256, RayGeneration::direct);
    for (const std::string walk :
         {"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack"}) {
        CAPTURE(walk);
        TraceRays trace({{"triangle", "geometry/triangle_watertight.glsl"},
                         {"structure", "structure/" + walk + ".glsl"}},
                        measure_limits());
        const Image image = show_hits(rays, trace.closest_hits(rays, textures), textures,
                                      scene.camera, scene.background, "view/normals.glsl");
        CHECK(unexpected_pixels(image, "06_bvh") == 0);
    }
}
