#pragma once

#include "image/image.h"

#include <cstddef>
#include <string>

namespace raysteps {

// The largest picture that is read, written or composed: it bounds what a damaged file can cost.
inline constexpr int most_columns_or_rows = 16384;
inline constexpr std::size_t most_pixels = std::size_t{1} << 26;

// Throws InputError, beginning with the name, where a side is under 1 or the picture is too large.
void check_size(const std::string& name, int width, int height);

// Also throws where the picture does not have width * height pixels.
void check_image(const std::string& name, const Image& image);

} // namespace raysteps
