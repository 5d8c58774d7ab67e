#pragma once

#include "structure/bvh_cut.h"

namespace raysteps {

// Half of the items on each side, along the axis on which their centres spread farthest. It knows
// no cost. Since it cuts by number and not by a plane, no side is empty, whatever the centres.
// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986.
std::optional<BvhCut> split_median(const BvhRange& range, const BvhOptions& options);

} // namespace raysteps
