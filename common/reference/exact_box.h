#pragma once

#include "geometry/box.h"
#include "geometry/layout.h"

namespace raysteps {

// Decides without rounding whether the ray meets the closed box at t_min or later, its sides and
// corners included; t_max is not asked. All numbers are finite, and the box is not empty.
bool exact_meets_box(const Ray& ray, const Box& box);

} // namespace raysteps
