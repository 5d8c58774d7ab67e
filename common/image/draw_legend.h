#pragma once

#include "image/heat_map_range.h"
#include "image/image.h"

#include <array>
#include <span>
#include <string>

namespace raysteps {

// The numbers under the bar: the lower end, the middle and the upper end, each with as many digits
// as it takes to tell them apart.
std::array<std::string, 3> legend_labels(const HeatMapRange& range);

// What the bar cannot show: how many values lie under or over the range, or are NaN. Empty where
// there is nothing to say.
std::string legend_note(std::span<const float> values, const HeatMapRange& range);

// A bar of the colors with its labels, over the title and the note: as wide as asked for, or wider
// where the labels need it.
Image draw_legend(const HeatMapRange& range, const std::string& title, const std::string& note,
                  int width);

} // namespace raysteps
