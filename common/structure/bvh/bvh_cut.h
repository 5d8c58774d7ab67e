#pragma once

#include "structure/bvh_item.h"
#include "structure/bvh_options.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace raysteps {

// The items of a node that is to be split, two at least, with the box around them and the box
// around their doubled centres.
struct BvhRange {
    std::span<const BvhItem> items;
    Box box;
    Box centers;
};

// Of the items in the order of their centres along the axis (of equal centres, the smaller triangle
// first), the first lower_count go to the first child: one at least, and not all. The cost is that
// of the split node for a ray that meets it; infinite where the rule knows no cost. Where all
// centres of the first child are less than those of the second, a rule may say what the latter
// begin with: then parting them takes one look at each.
struct BvhCut {
    int axis = 0;
    std::size_t lower_count = 0;
    double cost = std::numeric_limits<double>::infinity();
    std::optional<float> first_upper_center{}; // doubled
};

// A rule answers where a range is best cut; nothing where equal centres tell it nothing.
using BvhRule = std::optional<BvhCut> (*)(const BvhRange& range, const BvhOptions& options);

// What a ray that meets the range is expected to cost if it is split. A ray that meets a box with
// the surface S meets a box inside with the probability S_lower / S (see measure_bvh), so this is
//   traversal_cost + intersection_cost * (S_lower n_lower + S_upper n_upper) / S,
// n being numbers of triangles; `weighted` is the sum in brackets.
// Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990.
inline double split_cost(double weighted, const BvhRange& range, const BvhOptions& options) {
    return options.traversal_cost + options.intersection_cost * weighted / surface_area(range.box);
}

// The axis along which the box is longest; of equal lengths the first.
inline int longest_axis(const Box& box) {
    int longest = 0;
    double length = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double own =
            static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
        if (own > length) {
            longest = axis;
            length = own;
        }
    }
    return longest;
}

} // namespace raysteps
