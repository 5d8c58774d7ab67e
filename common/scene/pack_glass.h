#pragma once

#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <vector>

namespace raysteps {

// The texels of layout/glass.glsl, two a material.
std::vector<glm::vec4> pack_glass(const Scene& scene);

} // namespace raysteps
