#pragma once

#include "image/image.h"
#include "render/ray_textures.h"

namespace raysteps {

// Directions as colours: a direction of length 1 with the components -1 ... 1 as red, green and
// blue 0 ... 1.
Image show_directions(const RayTextures& rays);

} // namespace raysteps
