#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// The linear RGB color of a value from 0 (dark blue) to 1 (yellow), so that equal steps look equal
// and brightness only grows: viridis, from Smith, van der Walt and Firing, "mpl-colormaps", 2015
// (CC0). Values outside [0, 1] get the color of the nearer end; NaN is nan_color
// (count_nan_pixels.h).
glm::vec3 color_map(float value);

} // namespace raysteps
