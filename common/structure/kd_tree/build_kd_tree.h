#pragma once

#include "structure/kd_options.h"
#include "structure/kd_tree.h"

#include <glm/vec3.hpp>

#include <span>

namespace raysteps {

// The kd-tree over the triangles (three corners each), in O(n log n), by the surface-area heuristic
// or at medians of space. The tree does not depend on the number of threads.
//
// A node becomes a leaf where
// - it has no more than leaf_triangles triangles,
// - it is as deep as depth_limit allows, by default 8 + 1.3 log2 n,
// - every plane would make a child thinner than 8 paddings, or
// - no split pays: by area, where the best one costs no less than a leaf; at the median, where both
//   children keep all triangles. In a row of bad_splits of them the builder hopes for a better one
//   below, by area only where a child is rid of some triangle at least.
//
// It needs about 48 bytes a reference for each level that is under work, and the tree. Throws
// InputError where the tree would be larger than most_bytes, where a corner is not finite or
// farther out than 1.8e18, or where there are more than 2^28 triangles.
// Source: Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in
// O(N log N)", 2006. The depth is that of Havran, "Heuristic Ray Shooting Algorithms", 2000; bad
// splits are those of Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd ed., 2016.
KdTree build_kd_tree(std::span<const glm::vec3> corners, const KdOptions& options);

} // namespace raysteps
