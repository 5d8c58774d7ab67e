#pragma once

#include "effects/effects_renderer.h"

#include <string>

namespace raysteps {

// The effects of a plan with the reason of each, those that are not called for, and the passes with
// their parts.
std::string explain(const Plan& plan);

// What the last picture took: rays by kind, rays and passes that it was spared, and textures.
std::string explain(const EffectsRenderer& renderer);

} // namespace raysteps
