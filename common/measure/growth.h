#pragma once

#include <span>

namespace raysteps {

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
