#pragma once

#include "image/heat_map_range.h"
#include "image/image.h"

#include <span>
#include <string>

namespace raysteps {

// The values, row by row from the top one, as colors (color_map.h) over a legend: a bar of the
// colors, the values at its ends and middle, the title (name the unit in it), and how many values
// lie outside the range or are NaN. A picture narrower than its legend stands centered over it.
// Throws InputError where there are not width * height values, or the range is not one.
Image heat_map(std::span<const float> values, int width, int height, const HeatMapRange& range,
               const std::string& title);

} // namespace raysteps
