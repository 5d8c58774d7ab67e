#pragma once

#include "image/image.h"

#include <filesystem>

namespace raysteps {

// Writes the picture as 8-bit sRGB. Components are clamped to [0, 1] and rounded to the nearest
// step; a pixel that has NaN is magenta (count_nan_pixels counts them), so it cannot pass for
// black. Makes the folders that lack; a write that fails leaves the old file as it was. Throws
// InputError with the path and the reason.
void write_png(const std::filesystem::path& path, const Image& image);

} // namespace raysteps
