#pragma once

#include <span>

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

} // namespace raysteps
