#pragma once

#include "render/effects/plan.h"
#include "trace/trace_options.h"

#include <string>

namespace raysteps {

// The options of chapter 09 besides those that all chapters share.
struct EffectOptions {
    std::string effects; // forced on and off
    Quality quality;
    int samples = 0; // rays per pixel; 0 means what the scene says
    bool explain = false;
};

void add_effect_options(Options& options, EffectOptions& effects);

// The scene with the samples of the options, where they say any.
Scene with_samples(Scene scene, const EffectOptions& options);

// Renders the scene with its plan, shows or writes it, and tells what it took.
void render_effects(const PictureOptions& picture, const TraceOptions& tracing,
                    const EffectOptions& options, Context& context, const Scene& scene);

} // namespace raysteps
