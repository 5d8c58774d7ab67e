#pragma once

#include "image/image.h"

#include <vector>

namespace raysteps {

// The picture and its coarser levels: each half as wide and half as high as the last, rounded down,
// at least 1, until a single texel. A texel is the mean of the finer ones that it covers.
// Source: Williams, "Pyramidal parametrics", 1983.
std::vector<Image> picture_pyramid(const Image& picture);

} // namespace raysteps
