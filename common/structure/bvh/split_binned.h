#pragma once

#include "structure/bvh_cut.h"

namespace raysteps {

// The cut of least split_cost at one of bins - 1 equally spaced planes along each axis, in time
// linear in the items and the bins. There are options.bins of them, or four more than items where
// that is less.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007. There, only
// the longest axis is tried; here, all three are.
std::optional<BvhCut> split_binned(const BvhRange& range, const BvhOptions& options);

} // namespace raysteps
