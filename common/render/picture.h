#pragma once

#include "gpu/texture.h"
#include "image/image.h"

namespace raysteps {

// The colours of a float texture as an image: OpenGL's bottom row comes last.
Image read_image(const Texture& texture);

} // namespace raysteps
