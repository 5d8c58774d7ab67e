#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace raysteps {

// IEC 61966-2-1:1999, "Default RGB colour space - sRGB". Both functions go beyond [0, 1]: negative
// values stay on the straight part of the curve, and NaN stays NaN.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

// A linear component as the nearest of the 256 sRGB steps: [0, 1] is clamped, NaN is 0.
// A picture is never encoded by this alone: write_png shows a pixel that has NaN in magenta.
std::uint8_t encode_srgb(float linear);

// The linear component that one of the 256 sRGB steps stands for.
float decode_srgb(std::uint8_t step);

// The linear RGB color of a value from 0 (dark blue) to 1 (yellow), so that equal steps look equal
// and brightness only grows: viridis, from Smith, van der Walt and Firing, "mpl-colormaps", 2015
// (CC0). Values outside [0, 1] get the color of the nearer end; NaN is nan_color
// (image/image.h).
glm::vec3 color_map(float value);

} // namespace raysteps
