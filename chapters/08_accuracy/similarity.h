#pragma once

#include "image/image.h"

namespace raysteps {

// How alike two pictures look, by brightness, contrast and pattern in windows of 8 x 8 pixels: 1 is
// the same, 0 has nothing in common. Of the brightness as sRGB shows it (which is about even to the
// eye), the mean over windows that overlap by half. Pictures of equal size, 8 pixels wide and high
// at least; throws InputError else. Source: Wang, Bovik, Sheikh and Simoncelli, "Image Quality
// Assessment: From Error Visibility to Structural Similarity", 2004.
double structural_similarity(const Image& a, const Image& b);

} // namespace raysteps
