#include "catch.h"
#include "render/generate_rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "structure/reach.h"
#include "support/expected_picture.h"
#include "support/gpu_hits.h"

using namespace raysteps;

namespace {

// The program's default picture, at 256x256, by a structure built as the program builds it. A
// context must be current.
Image picture_by(const std::string& structure) {
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

} // namespace

TEST_CASE("the picture of chapter 04 is the expected one", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(picture_by("grid"), "04_grid") == 0);
}

TEST_CASE("the mailbox paints the picture of chapter 04", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(picture_by("grid_mailbox"), "04_grid") == 0);
}
