#pragma once

#include "image/image.h"

#include <array>
#include <span>
#include <string>

namespace raysteps {

enum class HeatMapScale {
    linear,
    logarithmic,
};

// The values of both ends of a heat map's colors: finite, lower < upper; where the scale is
// logarithmic, also 0 < lower.
struct HeatMapRange {
    float lower = 0.0f;
    float upper = 1.0f;
    HeatMapScale scale = HeatMapScale::linear;
};

// From the least to the greatest finite value; a logarithmic range leaves out those of 0 and less.
// Where all are equal, a linear range begins or ends at 0, and a logarithmic one spans half to
// double the value. Where there is none: 0 to 1, or 1 to 10.
HeatMapRange auto_range(std::span<const float> values, HeatMapScale scale = HeatMapScale::linear);

// Throws InputError where the range breaks its invariant.
void check_range(const HeatMapRange& range);

// Where a value lies in the range, from 0 to 1; outside it, 0 or 1; NaN stays NaN.
float fraction_of_range(float value, const HeatMapRange& range);

// The value at the middle of the colors: the mean of the ends, or their geometric mean.
double middle_of_range(const HeatMapRange& range);

// The values, row by row from the top one, as colors (color_map) over a legend: a bar of the
// colors, the values at its ends and middle, the title (name the unit in it), and how many values
// lie outside the range or are NaN. A picture narrower than its legend stands centered over it.
// Throws InputError where there are not width * height values, or the range is not one.
Image heat_map(std::span<const float> values, int width, int height, const HeatMapRange& range,
               const std::string& title);

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
