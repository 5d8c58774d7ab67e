#pragma once

#include "render/effects/plan.h"
#include "trace/trace_options.h"

#include <string>
#include <vector>

namespace raysteps {

// --prove: which scenes, and how often each picture is measured.
struct Proof {
    std::vector<std::string> scenes;
    int rounds = 5;
};

// Renders each scene with its planned effects, with every effect, and without each of its effects,
// one after the other in each round. Prints whether the first two are the same bit for bit and what
// they cost, what each effect costs, and draws a chart of it. A scene with nothing but diffuse
// light and hard shadows also runs through the renderer of chapter 03. False where bits differ, or
// a ray was cast for an effect that no scene called for.
bool prove_effects(const PictureOptions& picture, const TraceOptions& tracing, const Proof& proof,
                   const Quality& quality);

} // namespace raysteps
