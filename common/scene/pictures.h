#pragma once

#include "image/image_file.h"
#include "scene/scene.h"

#include <string>

namespace raysteps {

// A picture that a material names: a file, or one that lies in a model's file. Throws InputError
// where it cannot be read.
Image picture_of(const Scene& scene, const std::string& name);

// The same of its opacity.
Opacity opacity_of(const Scene& scene, const std::string& name);

// Finds the materials whose surfaces have holes: where the picture of a material's cutout_map, or
// else the alpha channel of its texture, is less opaque than its cutoff. A cutout_map that has no
// such place, or cannot be read, is left out, the latter with a message.
Scene find_cutouts(Scene scene);

} // namespace raysteps
