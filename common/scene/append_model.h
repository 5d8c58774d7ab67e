#pragma once

#include "scene/scene.h"

#include <glm/mat4x4.hpp>

namespace raysteps {

// The scene with the model's triangles, materials, lights, models and messages behind its own. The
// transform is affine and does not flatten. Normals are transformed by the inverse transpose and
// have length 1 again. Where the transform mirrors (its determinant is negative), the second and
// third corner of each triangle change places, so that a front stays a front. A coordinate may
// leave the range of floats: the caller checks bounds_of. The scene's origin is what is taken from
// coordinates in world space; the model's is what was taken from its own.
Scene append_model(Scene scene, Scene model, const glm::mat4& transform);

} // namespace raysteps
