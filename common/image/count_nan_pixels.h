#pragma once

#include "image/image.h"

#include <cstddef>

namespace raysteps {

// Red, green or blue is not a number: a picture that is right has no such pixel.
bool has_nan(const glm::vec3& pixel);

std::size_t count_nan_pixels(const Image& image);

// What stands for NaN in every picture that we write. No color map of ours comes near it.
inline constexpr glm::vec3 nan_color{1.0f, 0.0f, 1.0f};

} // namespace raysteps
