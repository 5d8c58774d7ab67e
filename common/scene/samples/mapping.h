#pragma once

#include "scene/scene.h"

namespace raysteps {

// The scene with texture coordinates for its triangles from `first` on, as if the picture, `size`
// wide and high, were laid on each from the axis that its plane faces most.
Scene map_flat(Scene scene, int first, float size);

// The scene with texture coordinates for its triangles from `first` on, as longitude and latitude
// around the center: the whole picture once around, its upper edge at the pole +y.
Scene map_around(Scene scene, int first, const glm::vec3& center);

} // namespace raysteps
