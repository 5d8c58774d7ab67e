#pragma once

#include "gpu/shaders.h"
#include "scene/scene.h"

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
    cutouts,
    vertex_colors,
    emissive_maps,
    normal_maps,
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

// An effect, and what in the scene calls for it: `material glass, 412 triangles`.
struct EffectCall {
    Effect effect = Effect::diffuse;
    std::string reason;
};

// The effects that the scene calls for through its materials, lights and camera, in the order of
// the table. Materials that cannot be seen call for nothing, but glass that is out of view still
// lets light through. Nor does a mirror that keeps at most `faintest` (Quality) of all light: no
// path counts more than 1, since no colour of a material is over 1, and so none goes on from there.
// The aspect ratio is that of the picture, width / height.
std::vector<EffectCall> effects_called_for(const Scene& scene, double aspect_ratio, float faintest);

// How many triangles of each material a ray from the camera may meet. Triangles that lie beyond one
// side of the view count as unseen, unless a mirror or glass is in view, which may show anything;
// or the camera has a lens, whose rays start beside the eye. Never too few.
std::vector<int> triangles_in_view(const Scene& scene, double aspect_ratio);

// The same without a view: all of them.
std::vector<int> triangles_of_materials(const Scene& scene);

// How far paths are followed, whatever the effects.
struct Quality {
    int max_bounces = 8;
    float faintest = 1.0f / 512.0f; // a path that counts at most this much sends no ray on
};

struct PlannedPass {
    std::string name; // of its file in shaders/pass (find_pass)
    Parts parts;
};

// What will run for a picture. Nothing else is compiled, allocated or launched.
struct Plan {
    std::vector<EffectCall> called; // by the scene
    EffectSet effects;              // those called for, as forced on and off
    std::vector<PlannedPass> passes;
    int camera_samples = 1; // rays per pixel
    int lamp_samples = 1;   // shadow rays that each hit sends to a light with an area
    Quality quality;
};

// The effects that the scene calls for at that aspect ratio, changed by the choice
// (choose_effects), and the passes that they need. Throws InputError where the choice is wrong.
Plan make_plan(const Scene& scene, double aspect_ratio, const std::string& choice,
               const Quality& quality);

inline bool has(const Plan& plan, Effect effect) {
    return plan.effects.contains(effect);
}

// Whether the plan's passes use the lights at all.
inline bool is_lit(const Plan& plan) {
    return has(plan, Effect::diffuse) || has(plan, Effect::highlights);
}

// Whether paths go on after their first hit.
inline bool goes_on(const Plan& plan) {
    return has(plan, Effect::mirrors) || has(plan, Effect::refraction);
}

// Whether it reads the texture coordinates of triangles and pictures by them.
inline bool reads_pictures(const Plan& plan) {
    return has(plan, Effect::textures) || has(plan, Effect::normal_maps) ||
           has(plan, Effect::emissive_maps);
}

inline bool needs_glass(const Plan& plan) {
    return has(plan, Effect::refraction) || has(plan, Effect::glass_shadows);
}

// The effects of a plan with the reason of each, those that are not called for, and the passes with
// their parts.
std::string explain(const Plan& plan);

} // namespace raysteps
