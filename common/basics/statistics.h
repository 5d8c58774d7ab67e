#pragma once

#include <span>
#include <string>
#include <vector>

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

struct GrowthPoint {
    double triangles = 0.0;
    double cost = 0.0;
};

// How a cost grows with the number of triangles: the k of cost = c * triangles^k that fits best,
// by least squares of the logarithms. 1 is linear growth, 0.5 that of the square root, 0 none;
// a logarithm has no exponent of its own, but over few powers of ten it looks like a small one.
// Throws InputError unless there are two different numbers of triangles at least, and all numbers
// are over 0.
double growth_exponent(std::span<const GrowthPoint> points);

} // namespace raysteps
