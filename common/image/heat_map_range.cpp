#include "image/heat_map_range.h"

#include "error/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace raysteps {

namespace {

constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float largest = std::numeric_limits<float>::max();

HeatMapRange range_around(float value, HeatMapScale scale) {
    if (scale == HeatMapScale::logarithmic) {
        const float upper = value > largest / 2.0f ? largest : 2.0f * value;
        return {std::max(value / 2.0f, smallest), upper, scale};
    }
    if (value == 0.0f) {
        return {0.0f, 1.0f, scale};
    }
    return {std::min(value, 0.0f), std::max(value, 0.0f), scale};
}

} // namespace

HeatMapRange auto_range(std::span<const float> values, HeatMapScale scale) {
    float lower = +std::numeric_limits<float>::infinity();
    float upper = -std::numeric_limits<float>::infinity();
    for (const float value : values) {
        const bool usable = scale == HeatMapScale::linear || value > 0.0f;
        if (std::isfinite(value) && usable) {
            lower = std::min(lower, value);
            upper = std::max(upper, value);
        }
    }
    if (lower > upper) {
        return scale == HeatMapScale::linear ? HeatMapRange{0.0f, 1.0f, scale}
                                             : HeatMapRange{1.0f, 10.0f, scale};
    }
    if (lower == upper) {
        return range_around(lower, scale);
    }
    return {lower, upper, scale};
}

void check_range(const HeatMapRange& range) {
    const bool finite = std::isfinite(range.lower) && std::isfinite(range.upper);
    const bool positive = range.scale == HeatMapScale::linear || range.lower > 0.0f;
    if (!finite || range.lower >= range.upper || !positive) {
        throw InputError("a heat map cannot go from " + std::to_string(range.lower) + " to " +
                         std::to_string(range.upper) +
                         ". Give finite ends, the lower one first, and over 0 where the scale is "
                         "logarithmic.");
    }
}

float fraction_of_range(float value, const HeatMapRange& range) {
    if (std::isnan(value)) {
        return value;
    }
    if (value <= range.lower) {
        return 0.0f;
    }
    if (value >= range.upper) {
        return 1.0f;
    }
    // In double, where neither the difference nor the quotient of two floats overflows.
    const double lower = range.lower;
    const double upper = range.upper;
    if (range.scale == HeatMapScale::logarithmic) {
        return static_cast<float>(std::log(value / lower) / std::log(upper / lower));
    }
    return static_cast<float>((value - lower) / (upper - lower));
}

double middle_of_range(const HeatMapRange& range) {
    const double lower = range.lower;
    const double upper = range.upper;
    return range.scale == HeatMapScale::logarithmic ? std::sqrt(lower * upper)
                                                    : (lower + upper) / 2.0;
}

} // namespace raysteps
