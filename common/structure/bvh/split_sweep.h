#pragma once

#include "structure/bvh_cut.h"

namespace raysteps {

// The cut of least split_cost between any two items along each axis; of equal costs along one axis,
// the one nearest to the middle. It sorts the items once an axis, so that a whole tree takes
// O(n log^2 n).
// Source: Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes using Dynamic Bounding Volume
// Hierarchies", 2007.
std::optional<BvhCut> split_sweep(const BvhRange& range, const BvhOptions& options);

} // namespace raysteps
