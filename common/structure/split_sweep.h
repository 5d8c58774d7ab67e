#pragma once

#include "structure/bvh_cut.h"

namespace raysteps {

// The cheapest of all planes between two centres along each axis, by the cost of split_binned; of
// equal costs, the plane nearest to the middle. It sorts the items once an axis, so that a whole
// tree takes O(n log^2 n).
// Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990, for the
// cost; Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume
// Hierarchies", 2007, for the sweep over centres.
std::optional<BvhCut> split_sweep(const BvhRange& range, const BvhOptions& options);

} // namespace raysteps
