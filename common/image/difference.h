#pragma once

#include "image/image.h"

#include <cstddef>

namespace raysteps {

// How far two pictures are apart, in linear RGB. The difference of two pixels is that of their
// components that differ most. NaN on either side is infinitely far from everything, so that no
// limit on rmse or max lets it pass; equal infinities do not differ.
struct Difference {
    double rmse = 0.0; // over all components of all pixels
    double max = 0.0;  // of the pixel that differs most
    int worst_column = 0;
    int worst_row = 0;
    std::size_t different_pixels = 0; // that differ by more than the threshold
    std::size_t nan_pixels = 0;       // that have NaN in either picture
    std::size_t pixels = 0;
};

// Throws InputError where the sizes differ, or the threshold is negative or not finite.
Difference difference(const Image& a, const Image& b, float threshold);

} // namespace raysteps
