#pragma once

#include "gpu/shaders.h"
#include "render/effects/called_for.h"

#include <string>
#include <vector>

namespace raysteps {

// How far paths are followed, whatever the effects.
struct Quality {
    int max_bounces = 8;
    float faintest = 1.0f / 512.0f; // a path that counts at most this much sends no ray on
};

struct PlannedPass {
    std::string name; // of shaders/pass/NAME.frag
    Parts parts;
};

// What will run for a picture. Nothing else is compiled, allocated or launched.
struct Plan {
    std::vector<EffectCall> called; // by the scene
    EffectSet effects;              // those called for, as forced on and off
    std::vector<PlannedPass> passes;
    int camera_samples = 1; // rays a pixel
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

// Whether the plan's passes ask lights at all.
inline bool is_lit(const Plan& plan) {
    return has(plan, Effect::diffuse) || has(plan, Effect::highlights);
}

// Whether paths go on behind their first hit.
inline bool goes_on(const Plan& plan) {
    return has(plan, Effect::mirrors) || has(plan, Effect::refraction);
}

inline bool needs_glass(const Plan& plan) {
    return has(plan, Effect::refraction) || has(plan, Effect::glass_shadows);
}

// The effects of a plan with the reason of each, those that are not called for, and the passes with
// their parts.
std::string explain(const Plan& plan);

} // namespace raysteps
