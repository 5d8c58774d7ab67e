#pragma once

#include "effects/effects.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace raysteps {

// An effect, and what in the scene calls for it: `material glass, 412 triangles`.
struct EffectCall {
    Effect effect = Effect::diffuse;
    std::string reason;
};

// The effects that the scene calls for through its materials, lights and camera, in the order of
// the table. Materials that cannot be seen call for nothing, but glass that is out of view still
// lets light through. The aspect ratio is that of the picture, width / height.
std::vector<EffectCall> effects_called_for(const Scene& scene, double aspect_ratio);

} // namespace raysteps
