#pragma once

#include "gpu/limits.h"

#include <cstddef>

namespace raysteps {

// How much work the comparisons make.
struct Effort {
    std::size_t judged_rays = 16384; // of each family
    std::size_t timed_rays = 4096;   // the first of them
    int rounds = 9;                  // after one that is dropped
    int picture_size = 96;           // pixels along a side
    int finest_grid = 512;           // cells across, where crossings are compared
    int most_samples = 3;            // along each side of a pixel, where samples are compared
    int seed = 1;
    Limits limits{};
};

} // namespace raysteps
