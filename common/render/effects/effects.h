#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// What a picture can show. Each is a row of the table list_effects.
enum class Effect {
    antialiasing,
    depth_of_field,
    sky,
    textures,
    diffuse,
    highlights,
    shadows,
    soft_shadows,
    glass_shadows,
    mirrors,
    refraction,
    absorption,
};

using EffectSet = std::set<Effect>;

// The name is what --effects knows; the passes are those of shaders/pass that run for this effect
// and for no other.
struct EffectRow {
    Effect effect = Effect::diffuse;
    std::string_view name;
    std::vector<std::string_view> passes;
    std::string_view meaning;
};

// All effects, in the order in which a path meets them.
const std::vector<EffectRow>& list_effects();

const EffectRow& row_of(Effect effect);

// The effect of that name. Throws InputError that lists the names.
Effect effect_of(std::string_view name);

EffectSet all_effects();

// The set with what `choice` says of it: `+refraction,-shadows` between commas; `+all` and `-all`
// mean every effect. Throws InputError where a word is none of that.
EffectSet choose_effects(EffectSet effects, std::string_view choice);

} // namespace raysteps
