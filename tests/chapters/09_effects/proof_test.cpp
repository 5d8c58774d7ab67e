#include "catch.h"
#include "effect_pictures.h"
#include "render/whitted_renderer.h"
#include "support/whitted_by_gpu.h"

#include <algorithm>

using namespace raysteps;

// Every scene with the effects that it calls for, and with all of them.

TEST_CASE("a picture with its planned effects has the bits of one with every effect",
          "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    for (const std::string name : {"cornell_box", "mirrors", "sphereflake:1", "compact:4", "knot:1",
                                   "pictures", "soft_light", "lens", "glass_box", "room"}) {
        CAPTURE(name);
        Scene scene = load_scene(name, 1.0f);
        scene.camera.samples = std::min(scene.camera.samples, 2);
        const EffectPicture planned = effect_picture(scene, 32);
        const EffectPicture everything = effect_picture(scene, 32, "+all");
        CHECK(count_different(planned.image, everything.image) == 0);
        CHECK(planned.plan.effects != everything.plan.effects);
    }
}

TEST_CASE("no ray is cast for an effect that no scene calls for", "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    for (const std::string choice : {"", "+all"}) {
        CAPTURE(choice);
        const RayTally tally = effect_picture(load_scene("cornell_box", 1.0f), 32, choice).tally;
        CHECK(tally.camera == 1024);
        CHECK(tally.shadow > 0);
        CHECK(tally.soft_shadow + tally.behind_glass + tally.mirror + tally.refracted +
                  tally.reflected_by_glass ==
              0);
        CHECK(tally.waves == 1);
    }
    const RayTally dark = effect_picture(load_scene("cornell_box", 1.0f), 32, "-shadows").tally;
    CHECK(all_rays(dark) == 1024);
}

TEST_CASE("a mirror too dark to send a ray is left out of the plan and changes no pixel",
          "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    Material mirror;
    mirror.specular = glm::vec3(0.001f);
    mirror.illumination_model = 3;
    mirror.emission = glm::vec3(0.25f);
    Scene scene = add_mesh(white_scene(), facing_wall(-1.0f, 2.0f), mirror);
    scene.background = glm::vec3(1000.0f); // a thousandth of it would show
    const EffectPicture planned = effect_picture(scene, 32);
    const EffectPicture everything = effect_picture(scene, 32, "+all");
    CHECK(!has(planned.plan, Effect::mirrors));
    CHECK(count_different(planned.image, everything.image) == 0);
    CHECK(planned.tally.mirror + everything.tally.mirror == 0);
    CHECK(everything.tally.faint > 0); // they were meant to go on
    const EffectPicture followed = effect_picture(scene, 32, "", {.faintest = 0.0f});
    CHECK(followed.tally.mirror > 0);
    CHECK(count_different(followed.image, everything.image) > 0);
}

TEST_CASE("diffuse surfaces shadows and mirrors have the bits of chapter 03", "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    for (const std::string name : {"cornell_box", "mirrors", "compact:4", "sphereflake:1"}) {
        CAPTURE(name);
        const Scene scene = load_scene(name, 1.0f);
        const Image expected = whitted_by_gpu(scene, 40, 40, 8);
        const Quality all_paths{.max_bounces = 8, .faintest = 0.0f};
        CHECK(count_different(effect_picture(scene, 40, "-highlights", all_paths).image,
                              expected) == 0);
    }
}

TEST_CASE("a path that counts less than the threshold changes a pixel by no more than it could",
          "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    // A room that shines with at most 1 everywhere: a path that is cut takes at most its weight,
    // and of the cut paths of one pixel each took at most `faintest`.
    Scene scene = add_mesh(white_scene(), sphere({0, 0, 0}, 0.5f, 6), clear_glass(1.5f));
    const Image whole = effect_picture(scene, 24, "", {.faintest = 0.0f}).image;
    const Quality cut{.faintest = 1.0f / 512.0f};
    const EffectPicture spared = effect_picture(scene, 24, "", cut);
    CHECK(spared.tally.faint > 0);
    // A tree of depth 8 in a ball: a cut leaves a path on which nothing else is cut, so at most one
    // cut for each of the 8 surfaces and each of the paths that are followed, of which a pixel has
    // at most one for each two surfaces.
    const float bound = 8.0f * 4.0f / 512.0f;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        CHECK(whole.pixels[i].x - spared.image.pixels[i].x <= bound);
        CHECK(whole.pixels[i].x - spared.image.pixels[i].x >= -1e-6f);
    }
}

TEST_CASE("lamps behind all surfaces cost no shadow ray", "[09][proof]") {
    const auto context = make_context(ContextKind::automatic);
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 9.0f), Material{});
    scene.lights = {
        {{0, 0, -3}, glm::vec3(1)}, {{0, 0, 3}, glm::vec3(1)}, {{1, 0, 3}, glm::vec3(0)}};
    const RayTally tally = effect_picture(scene, 16).tally;
    CHECK(tally.shadow == 256);
    CHECK(tally.facing_away == 256);
    CHECK(tally.lamps_skipped == 2); // the one behind, and the black one
}
