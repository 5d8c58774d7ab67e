#include "render/effects/effects.h"

#include "basics/error.h"

namespace raysteps {

namespace {

std::string list_names() {
    std::string names;
    for (const EffectRow& row : list_effects()) {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    return names;
}

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
        {Effect::antialiasing, "antialiasing", {"spread_rays"}, "many rays a pixel"},
        {Effect::depth_of_field, "depth_of_field", {"lens_rays"}, "a lens instead of a pinhole"},
        {Effect::sky, "sky", {"add_sky"}, "a background that depends on the direction"},
        {Effect::textures, "textures", {"paint_surface"}, "pictures on surfaces (map_Kd)"},
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
        {Effect::absorption, "absorption", {"absorb"}, "glass that swallows light (Tf)"},
    };
    return rows;
}

const EffectRow& row_of(Effect effect) {
    return list_effects()[static_cast<std::size_t>(effect)];
}

Effect effect_of(std::string_view name) {
    for (const EffectRow& row : list_effects()) {
        if (row.name == name) {
            return row.effect;
        }
    }
    throw InputError("There is no effect \"" + std::string(name) + "\". Take one of " +
                     list_names() + ", or all.");
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

} // namespace raysteps
