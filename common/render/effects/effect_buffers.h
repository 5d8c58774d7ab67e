#pragma once

#include "render/scene_textures.h"
#include "render/effects/plan.h"
#include "gpu/program.h"
#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// The texels of light/materials.glsl under a plan: a material is marked as a mirror where the plan
// sends rays on from it, and shows only that part of its colour which does not go through it.
std::vector<glm::vec4> pack_planned_materials(const Scene& scene, const Plan& plan);

// The texels of light/highlight.glsl, one a material.
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

// The programs of a plan, compiled and given what stays the same for all pictures of the scene. To
// ask for one that the plan does not have is a fault of the caller.
class PlannedPasses {
public:
    PlannedPasses(const Plan& plan, const SceneTextures& scene, const EffectBuffers& effects);

    Program& operator[](const std::string& name) { return programs_.at(name); }

private:
    std::map<std::string, Program> programs_;
};

} // namespace raysteps
