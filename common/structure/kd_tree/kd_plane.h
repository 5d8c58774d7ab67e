#pragma once

#include "structure/kd_events.h"
#include "structure/kd_options.h"

namespace raysteps {

// A plane to split a box at, and how many triangles have a part on each side.
struct KdPlane {
    int axis = -1; // none found
    float position = 0.0f;
    std::size_t lower_count = 0;
    std::size_t upper_count = 0;
    double cost = 0.0; // expected, of a ray through the box
};

inline bool was_found(const KdPlane& plane) {
    return plane.axis >= 0;
}

// Half of the surface of the box, in double: the square of a float may be no float.
double half_area(const Box& box);

// A child thinner than this has no plane far enough from its sides to be told apart by rounded
// distances, and nothing to gain: triangles are two paddings thick.
inline constexpr double least_width_in_paddings = 8.0;

// The plane of least cost over all events, by the surface-area heuristic: a ray through the box
// goes through a child with the probability of the ratio of their surfaces, and a split costs
//   traversal_cost + intersection_cost * (p_lower * lower_count + p_upper * upper_count),
// less the bonus where a side is empty. No plane stands so near to a side of the box that a child
// would be thinner than 8 paddings. Source: MacDonald and Booth, "Heuristics for ray tracing using
// space subdivision", 1990; swept as in Wald and Havran, "On building fast kd-trees for ray
// tracing, and on doing that in O(N log N)", 2006.
KdPlane cheapest_plane(const KdEvents& events, const Box& box, double padding,
                       const KdOptions& options);

// The middle of the longest side, where the children are not too thin.
KdPlane middle_plane(const KdEvents& events, const Box& box, double padding);

} // namespace raysteps
