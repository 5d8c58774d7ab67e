#include "render/effects/plan.h"

#include "basics/error.h"
#include "basics/text.h"

#include <algorithm>

namespace raysteps {

namespace {

EffectSet chosen(std::string_view name) {
    return name == "all" ? all_effects() : EffectSet{effect_of(name)};
}

EffectSet changed(EffectSet effects, std::string_view word) {
    if (word.empty() || (word[0] != '+' && word[0] != '-')) {
        throw InputError("--effects \"" + std::string(word) +
                         "\": write + before an effect to force it on, - to force it off.");
    }
    for (const Effect effect : chosen(word.substr(1))) {
        if (word[0] == '+') {
            effects.insert(effect);
        } else {
            effects.erase(effect);
        }
    }
    return effects;
}

} // namespace

const std::vector<EffectRow>& list_effects() {
    static const std::vector<EffectRow> rows = {
        {Effect::antialiasing, "antialiasing", {"spread_rays"}, "many rays per pixel"},
        {Effect::depth_of_field, "depth_of_field", {"lens_rays"}, "a lens instead of a pinhole"},
        {Effect::sky, "sky", {"add_sky"}, "a background that depends on the direction"},
        {Effect::textures, "textures", {"paint_surface"}, "textures (map_Kd)"},
        {Effect::diffuse, "diffuse", {"light_surface"}, "matte light (Kd)"},
        {Effect::highlights, "highlights", {"add_highlight"}, "glossy highlights (Ks, Ns)"},
        {Effect::shadows, "shadows", {"cast_lamp_rays"}, "shadow rays to the lights"},
        {Effect::soft_shadows, "soft_shadows", {}, "lights with an area (the part lamp/area.glsl)"},
        {Effect::glass_shadows,
         "glass_shadows",
         {"dim_light", "reach_lamp"},
         "light that comes through glass"},
        {Effect::mirrors, "mirrors", {"reflect"}, "mirrored rays (illum 3, Ks)"},
        {Effect::refraction,
         "refraction",
         {"refract", "reflect_off_glass", "carry_media", "scatter_light"},
         "glass: refracted and reflected rays (illum 4, 6, 7, 9 or d < 1; Ni)"},
        {Effect::absorption, "absorption", {"absorb"}, "glass that absorbs light (Tf)"},
        {Effect::cutouts,
         "cutouts",
         {},
         "surfaces with holes (map_d, alpha; the walks' part cutout/pictures.glsl)"},
        {Effect::vertex_colors, "vertex_colors", {"tint_surface"}, "colours of vertices"},
        {Effect::emissive_maps,
         "emissive_maps",
         {"add_glow"},
         "surfaces that glow by a picture (map_Ke)"},
        {Effect::normal_maps, "normal_maps", {"bend_normals"}, "normals bent by a picture (norm)"},
    };
    return rows;
}

const EffectRow& row_of(Effect effect) {
    return list_effects()[static_cast<std::size_t>(effect)];
}

Effect effect_of(std::string_view name) {
    std::vector<std::string_view> names;
    for (const EffectRow& row : list_effects()) {
        if (row.name == name) {
            return row.effect;
        }
        names.push_back(row.name);
    }
    names.emplace_back("all");
    throw InputError(no_such_choice("--effects", name, "effect", names));
}

EffectSet all_effects() {
    EffectSet effects;
    for (const EffectRow& row : list_effects()) {
        effects.insert(row.effect);
    }
    return effects;
}

EffectSet choose_effects(EffectSet effects, std::string_view choice) {
    while (!choice.empty()) {
        const std::size_t comma = choice.find(',');
        effects = changed(std::move(effects), choice.substr(0, comma));
        choice = comma == std::string_view::npos ? "" : choice.substr(comma + 1);
    }
    return effects;
}

namespace {

// For a scene with a lens or an area light that does not say how many rays it wants.
constexpr int usual_samples = 16;

// Some effects build on others, and mean nothing without them.
EffectSet without_the_baseless(EffectSet effects, const EffectSet& forced_off) {
    const auto needs = [&](Effect effect, bool base) {
        if (!base) {
            effects.erase(effect);
        }
    };
    const bool lit = effects.contains(Effect::diffuse) || effects.contains(Effect::highlights);
    needs(Effect::textures, effects.contains(Effect::diffuse));
    needs(Effect::vertex_colors, effects.contains(Effect::diffuse));
    needs(Effect::normal_maps, lit);
    needs(Effect::shadows, lit);
    needs(Effect::soft_shadows, effects.contains(Effect::shadows));
    needs(Effect::glass_shadows,
          effects.contains(Effect::shadows) && !forced_off.contains(Effect::refraction));
    needs(Effect::absorption, effects.contains(Effect::refraction));
    return effects;
}

int samples_of(const Plan& plan, const Scene& scene) {
    if (scene.camera.samples > 0) {
        return scene.camera.samples;
    }
    const bool spreads = (has(plan, Effect::depth_of_field) && scene.camera.aperture > 0.0f) ||
                         (has(plan, Effect::soft_shadows) &&
                          std::any_of(scene.lights.begin(), scene.lights.end(), has_area));
    return spreads ? usual_samples : 1;
}

// The camera's rays and the lamps' share the samples: where each pixel has many rays, each of them
// needs one point of a lamp only. An effect that was forced on without being called for adds none.
Plan with_samples(Plan plan, const Scene& scene) {
    const int samples = samples_of(plan, scene);
    const bool many_rays = (has(plan, Effect::antialiasing) && scene.camera.samples > 1) ||
                           (has(plan, Effect::depth_of_field) && scene.camera.aperture > 0.0f);
    plan.camera_samples = many_rays ? samples : 1;
    plan.lamp_samples = many_rays ? 1 : samples;
    return plan;
}

std::string visibility_of(const Plan& plan) {
    if (!has(plan, Effect::shadows)) {
        return "visibility/open.glsl";
    }
    return has(plan, Effect::glass_shadows) ? "visibility/filtered.glsl" : "visibility/traced.glsl";
}

std::vector<PlannedPass> lamp_passes(const Plan& plan) {
    const std::string lamp = has(plan, Effect::soft_shadows) ? "lamp/area.glsl" : "lamp/point.glsl";
    const std::string normal =
        has(plan, Effect::normal_maps) ? "normal/mapped.glsl" : "normal/interpolated.glsl";
    const Parts parts{{"lamp", lamp}, {"normal", normal}, {"visibility", visibility_of(plan)}};
    std::vector<PlannedPass> passes{{"select_all", {}}};
    if (has(plan, Effect::textures)) {
        passes.push_back({"paint_surface", {}});
    }
    const std::string by_texture =
        has(plan, Effect::textures) ? "paint/painted.glsl" : "paint/plain.glsl";
    if (has(plan, Effect::vertex_colors)) {
        passes.push_back({"tint_surface", {{"paint", by_texture}}});
    }
    if (has(plan, Effect::normal_maps)) {
        passes.push_back({"bend_normals", {}});
    }
    if (has(plan, Effect::shadows)) {
        passes.push_back({"cast_lamp_rays", {{"lamp", lamp}, {"normal", normal}}});
        passes.push_back({"select_rays", {}});
    }
    if (has(plan, Effect::glass_shadows)) {
        passes.push_back({"start_weights", {}});
        passes.push_back({"select_empty_rays", {}});
        passes.push_back({"reach_lamp", {}});
        passes.push_back({"dim_light", {}});
        passes.push_back({"select_no_glass", {}});
    }
    if (has(plan, Effect::diffuse)) {
        Parts painted = parts;
        painted["paint"] = has(plan, Effect::vertex_colors) ? "paint/painted.glsl" : by_texture;
        passes.push_back({"light_surface", painted});
    }
    if (has(plan, Effect::highlights)) {
        passes.push_back({"add_highlight", parts});
    }
    return passes;
}

std::vector<PlannedPass> bounce_passes(const Plan& plan) {
    std::vector<PlannedPass> passes{{"select_all", {}}, {"select_unmirrored", {}}};
    if (has(plan, Effect::mirrors)) {
        passes.push_back({"reflect", {}});
    }
    if (has(plan, Effect::refraction)) {
        passes.push_back({"select_glass", {}});
        passes.push_back({"reflect_off_glass", {}});
        passes.push_back({"carry_media", {}});
        passes.push_back({"refract", {}});
        passes.push_back({"scatter_light", {}});
    }
    passes.push_back({"select_faint", {}});
    return passes;
}

// In the order in which they run; each once.
std::vector<PlannedPass> passes_of(const Plan& plan) {
    std::vector<PlannedPass> all;
    if (!has(plan, Effect::antialiasing)) {
        all.push_back({"compute_rays", {}}); // by chapter 01's generate_rays
    } else {
        all.push_back({"spread_rays", {}});
    }
    if (has(plan, Effect::depth_of_field)) {
        all.push_back({"lens_rays", {}});
    }
    all.push_back({"start_weights", {}});
    if (has(plan, Effect::absorption)) {
        all.push_back({"absorb", {}});
    }
    all.push_back({"add_surroundings", {}});
    if (has(plan, Effect::sky)) {
        all.push_back({"add_sky", {}});
    }
    all.push_back({"select_misses", {}});
    if (has(plan, Effect::emissive_maps)) {
        all.push_back({"add_glow", {}});
    }
    const auto append = [&](const std::vector<PlannedPass>& passes) {
        for (const PlannedPass& pass : passes) {
            const bool is_there = std::any_of(all.begin(), all.end(), [&](const PlannedPass& one) {
                return one.name == pass.name;
            });
            if (!is_there) {
                all.push_back(pass);
            }
        }
    };
    if (is_lit(plan)) {
        append(lamp_passes(plan));
    }
    if (goes_on(plan)) {
        append(bounce_passes(plan));
    }
    return all;
}

} // namespace

Plan make_plan(const Scene& scene, double aspect_ratio, const std::string& choice,
               const Quality& quality) {
    Plan plan;
    plan.quality = quality;
    plan.called = effects_called_for(scene, aspect_ratio, quality.faintest);
    for (const EffectCall& call : plan.called) {
        plan.effects.insert(call.effect);
    }
    const EffectSet kept = choose_effects(all_effects(), choice);
    EffectSet forced_off;
    for (const Effect effect : all_effects()) {
        if (!kept.contains(effect)) {
            forced_off.insert(effect);
        }
    }
    plan.effects = without_the_baseless(choose_effects(plan.effects, choice), forced_off);
    plan = with_samples(std::move(plan), scene);
    plan.passes = passes_of(plan);
    return plan;
}

} // namespace raysteps
