#pragma once

#include <vector>

namespace raysteps {

// What the rounds of a measurement come to: the value in the middle, and both ends.
struct MeasuredRange {
    double median = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
};

// Of at least one value, none of which is NaN. Of an even number, the median is the greater of the
// two in the middle: a value that was measured.
MeasuredRange measured_range(std::vector<double> values);

// Whether every round of a was below every round of b. Where neither lies below the other, their
// ranges overlap, and no rank is given.
bool lies_below(const MeasuredRange& a, const MeasuredRange& b);

} // namespace raysteps
