#pragma once

#include "structure/bvh.h"
#include "structure/bvh_insertion.h"

#include <span>

namespace raysteps {

// The tree over the items in the form of a Bvh. A subtree of no more than leaf_triangles becomes a
// leaf where that costs no more. Where the tree grows beyond depth_limit, its items are halved from
// there on instead (see grow_bvh). Only nodes and order are filled in.
Bvh flattened(const InsertionTree& tree, std::span<const BvhItem> items, const BvhOptions& options);

} // namespace raysteps
