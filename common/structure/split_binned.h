#pragma once

#include "structure/bvh_cut.h"

namespace raysteps {

// The cheapest of bins - 1 equally spaced planes along each axis, in time linear in the items and
// the bins. The expected cost of a split is
//   traversal_cost + intersection_cost * (S_lower n_lower + S_upper n_upper) / S,
// S being surface areas and n numbers of triangles.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007. There, only
// the longest axis is tried; here, all three are.
std::optional<BvhCut> split_binned(const BvhRange& range, const BvhOptions& options);

} // namespace raysteps
