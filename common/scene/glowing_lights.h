#pragma once

#include "scene/scene.h"

#include <vector>

namespace raysteps {

// At most so many: every light costs a shadow ray at every point.
inline constexpr std::size_t most_glowing_lights = 16;

// The lights that the model itself has: two triangles in a row whose material glows (Ke), and which
// make a parallelogram, are a light with that area. Light does not fade with the distance here, so
// only the colour of Ke counts: one that is brighter than 1 is scaled to 1. What glows and is no
// such light is told to the messages of the scene.
std::vector<Light> glowing_lights(Scene& scene);

} // namespace raysteps
