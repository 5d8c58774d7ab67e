#pragma once

#include "effects/effect_buffers.h"
#include "effects/plan.h"
#include "gpu/program.h"
#include "render/scene_textures.h"

#include <map>
#include <string>

namespace raysteps {

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
