#pragma once

#include "structure/bvh.h"
#include "structure/bvh_cut.h"

#include <span>
#include <vector>

namespace raysteps {

// The nodes of a tree over the items, which it rearranges: a leaf's part of the order is its part
// of the items. The common loop of all builders from the top down, and it recurses nowhere:
// - a range becomes a leaf where it has no more than leaf_triangles items, and either the rule
//   knows no cut or its cut costs no less than the leaf;
// - else it is cut where the rule says, or in the middle where the rule knows no cut;
// - where the rest of depth_limit only just suffices, it is cut in the middle whatever the rule
//   says, so that no leaf is deeper than depth_limit or than log2(n / leaf_triangles), rounded up.
// The depth is that of the root. On so many threads as the options say; the nodes do not depend on
// their number.
std::vector<BvhNode> grow_bvh(std::span<BvhItem> items, BvhRule rule, const BvhOptions& options,
                              int depth);

// Must a node of so many triangles at this depth be halved, or be made a leaf, to keep the
// depth_limit?
bool is_at_depth_limit(std::size_t count, int depth, const BvhOptions& options);

// The nodes with a branch in place of the given node. The branch's leaves are moved by `first` in
// the order.
std::vector<BvhNode> graft(std::vector<BvhNode> nodes, std::size_t node,
                           std::span<const BvhNode> branch, std::size_t first);

} // namespace raysteps
