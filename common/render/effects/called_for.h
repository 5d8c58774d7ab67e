#pragma once

#include "render/effects/effects.h"
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

// How many triangles of each material a ray from the camera may meet. Triangles that lie beyond one
// side of the view count as unseen, unless a mirror or glass is in view, which may show anything;
// or the camera has a lens, whose rays start beside the eye. Never too few.
std::vector<int> triangles_in_view(const Scene& scene, double aspect_ratio);

// The same without a view: all of them.
std::vector<int> triangles_of_materials(const Scene& scene);

} // namespace raysteps
