#pragma once

#include "image/image.h"

#include <filesystem>

namespace raysteps {

// The colors of a PNG, JPEG or BMP file as linear RGB; opacity is left out, and 16-bit files become
// 8-bit ones. What it is, its content says, not its name. Throws InputError where the file is none
// of these, is damaged, or is larger than check_image.h allows.
Image read_picture(const std::filesystem::path& path);

} // namespace raysteps
