#pragma once

#include "effects/plan.h"
#include "gpu/program.h"
#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// The texels of layout/surfaces.glsl under a plan: a material is marked as a mirror where the plan
// sends rays on from it, and shows only that part of its colour which does not go through it.
std::vector<glm::vec4> pack_planned_materials(const Scene& scene, const Plan& plan);

// The texels of layout/gloss.glsl, one a material.
std::vector<glm::vec4> pack_gloss(const Scene& scene);

// Arrays that only some effects read, by the names of their uniforms; empty where the plan has none
// of those effects.
struct EffectBuffers {
    std::map<std::string, BufferTexture> buffers;
    std::vector<std::string> messages; // of pictures that could not be read
    std::size_t bytes = 0;
};

EffectBuffers upload_effects(const Scene& scene, const Plan& plan);

void bind(Program& program, const EffectBuffers& buffers);

} // namespace raysteps
