#include "catch.h"
#include "effect_pictures.h"
#include "support/error_of.h"

#include <algorithm>

using namespace raysteps;

namespace {

EffectSet called(const Scene& scene) {
    EffectSet effects;
    for (const EffectCall& call : effects_called_for(scene, 1.0, Quality{}.faintest)) {
        effects.insert(call.effect);
    }
    return effects;
}

std::string reason(const Scene& scene, Effect effect) {
    for (const EffectCall& call : effects_called_for(scene, 1.0, Quality{}.faintest)) {
        if (call.effect == effect) {
            return call.reason;
        }
    }
    return "";
}

bool runs(const Plan& plan, const std::string& pass) {
    return std::any_of(plan.passes.begin(), plan.passes.end(),
                       [&](const PlannedPass& one) { return one.name == pass; });
}

} // namespace

TEST_CASE("the table of effects has a row for each in its order", "[09][plan]") {
    const std::vector<EffectRow>& rows = list_effects();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(static_cast<std::size_t>(rows[i].effect) == i);
        CHECK(effect_of(rows[i].name) == rows[i].effect);
    }
    CHECK(all_effects().size() == rows.size());
}

TEST_CASE("each scene calls for what its materials lights and camera say", "[09][plan]") {
    using E = Effect;
    CHECK(called(load_scene("compact:4", 1.0f)) == EffectSet{E::diffuse, E::shadows});
    CHECK(called(load_scene("cornell_box", 1.0f)) == EffectSet{E::diffuse, E::shadows});
    CHECK(called(load_scene("mirrors", 1.0f)) ==
          EffectSet{E::diffuse, E::highlights, E::shadows, E::mirrors});
    CHECK(called(load_scene("pictures", 1.0f)) ==
          EffectSet{E::textures, E::diffuse, E::highlights, E::shadows});
    CHECK(called(load_scene("soft_light", 1.0f)) ==
          EffectSet{E::diffuse, E::shadows, E::soft_shadows});
    CHECK(called(load_scene("lens", 1.0f)) == EffectSet{E::antialiasing, E::depth_of_field, E::sky,
                                                        E::textures, E::diffuse, E::highlights,
                                                        E::shadows});
    CHECK(called(load_scene("glass_box", 1.0f)) ==
          EffectSet{E::diffuse, E::highlights, E::shadows, E::soft_shadows, E::glass_shadows,
                    E::mirrors, E::refraction, E::absorption});
}

TEST_CASE("a reason names materials and counts triangles", "[09][plan]") {
    const Scene scene = add_mesh(white_scene(), box({-1, -1, -1}, {1, 1, 1}), clear_glass(1.5f));
    CHECK(reason(scene, Effect::refraction) == "material glass, 12 triangles");
    CHECK(reason(scene, Effect::mirrors).empty());
}

TEST_CASE("glass out of view calls for no refraction but still for its shadow", "[09][plan]") {
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 1.0f), Material{});
    scene.lights = {{{0.0f, 0.0f, 20.0f}, glm::vec3(1.0f)}};
    scene = add_mesh(scene, box({-1, -1, 8}, {1, 1, 9}), clear_glass(1.5f)); // behind the camera
    const EffectSet effects = called(scene);
    CHECK(!effects.contains(Effect::refraction));
    CHECK(effects.contains(Effect::glass_shadows));
    // A mirror in view may show it.
    Material mirror;
    mirror.specular = glm::vec3(1.0f);
    mirror.illumination_model = 3;
    CHECK(called(add_mesh(scene, facing_wall(-1.0f, 2.0f), mirror)).contains(Effect::refraction));
}

TEST_CASE("mirrors too dark to send a ray call for nothing", "[09][plan]") {
    Material mirror;
    mirror.name = "dark";
    mirror.specular = {0.0f, 0.001f, 0.0005f};
    mirror.illumination_model = 3;
    const Scene dark = add_mesh(white_scene(), facing_wall(-1.0f, 2.0f), mirror);
    CHECK(!called(dark).contains(Effect::mirrors)); // 0.001 < 1/512
    CHECK(!runs(make_plan(dark, 1.0, "", {}), "reflect"));
    CHECK_THAT(explain(make_plan(dark, 1.0, "", {})), contains_text("mirrors"));
    CHECK(has(make_plan(dark, 1.0, "", {.faintest = 0.0005f}), Effect::mirrors));
    CHECK(!has(make_plan(dark, 1.0, "", {.faintest = 0.001f}), Effect::mirrors)); // as the passes
    CHECK(has(make_plan(dark, 1.0, "+mirrors", {}), Effect::mirrors));
    // Beside a bright one, only that one is the reason.
    mirror.name = "bright";
    mirror.specular = glm::vec3(0.5f);
    CHECK(reason(add_mesh(dark, facing_wall(-1.0f, 2.0f), mirror), Effect::mirrors) ==
          "material bright, 2 triangles");
}

TEST_CASE("a plan has the passes of its effects and no others", "[09][plan]") {
    const Plan plain = make_plan(load_scene("cornell_box", 1.0f), 1.0, "", {});
    CHECK(runs(plain, "light_surface"));
    CHECK(runs(plain, "cast_lamp_rays"));
    for (const Effect effect : all_effects()) {
        for (const std::string_view pass : row_of(effect).passes) {
            CAPTURE(pass);
            CHECK(runs(plain, std::string(pass)) == has(plain, effect));
        }
    }
    const Plan everything = make_plan(load_scene("cornell_box", 1.0f), 1.0, "+all", {});
    for (const EffectRow& row : list_effects()) {
        for (const std::string_view pass : row.passes) {
            CAPTURE(pass);
            CHECK(runs(everything, std::string(pass)));
        }
    }
}

TEST_CASE("effects can be forced on and off and take what rests on them along", "[09][plan]") {
    const Scene scene = load_scene("glass_box", 1.0f);
    const Plan plan = make_plan(scene, 1.0, "-shadows,-refraction,+textures", {});
    CHECK(!has(plan, Effect::shadows));
    CHECK(!has(plan, Effect::soft_shadows));
    CHECK(!has(plan, Effect::glass_shadows));
    CHECK(!has(plan, Effect::refraction));
    CHECK(!has(plan, Effect::absorption));
    CHECK(has(plan, Effect::textures));
    CHECK_THAT(error_of([&] { make_plan(scene, 1.0, "+fog", {}); }),
               contains_text("--effects fog: there is no such effect. Take one of antialiasing"));
    CHECK_THAT(error_of([&] { make_plan(scene, 1.0, "fog", {}); }), contains_text("write +"));
}

TEST_CASE("samples go to the camera where it spreads rays and else to the lamps", "[09][plan]") {
    Scene scene = load_scene("soft_light", 1.0f);
    CHECK(make_plan(scene, 1.0, "", {}).camera_samples == 1);
    CHECK(make_plan(scene, 1.0, "", {}).lamp_samples == 16);
    scene.camera.samples = 9;
    CHECK(make_plan(scene, 1.0, "", {}).camera_samples == 9);
    CHECK(make_plan(scene, 1.0, "", {}).lamp_samples == 1);
    CHECK(make_plan(scene, 1.0, "-antialiasing", {}).camera_samples == 1);
    CHECK(make_plan(scene, 1.0, "-antialiasing", {}).lamp_samples == 9);
}
