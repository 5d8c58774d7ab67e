#pragma once

#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace raysteps {

// The texels that the kernels and their mirror read, as core/triangles.glsl and
// light/materials.glsl say. The fourth number of a texel is 0 where nothing is said of it.
std::vector<glm::vec4> pack_vectors(std::span<const glm::vec3> vectors);

// Three texels per material: diffuse; specular, and 1 in w where it is a mirror; emission.
std::vector<glm::vec4> pack_materials(std::span<const Material> materials);

// The texels of light/glass_materials.glsl, two per material.
std::vector<glm::vec4> pack_glass(const Scene& scene);

// The texels of light/highlight.glsl, one per material: its colour, and its exponent in w.
std::vector<glm::vec4> pack_gloss(const Scene& scene);

} // namespace raysteps
