#pragma once

#include <span>
#include <string>

namespace raysteps {

// What many measured values come to. A percentile is a value that was measured, not one between
// two.
struct Summary {
    double median = 0.0;
    double percentile_99 = 0.0;
    double largest = 0.0;
};

// Of at least one value, none of which is NaN.
Summary summarize(std::span<const float> values);

// `median 0.5, 99 % up to 1.2, largest 3`
std::string to_string(const Summary& summary);

} // namespace raysteps
