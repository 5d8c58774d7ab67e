#pragma once

#include "structure/kd_tree.h"

namespace raysteps {

// The tree with its leaves numbered and a rope behind each face of each leaf: the smallest node
// that holds the whole face. So a walk that leaves a leaf goes on there, and not at the root.
// Source: Havran, Bittner and Zara, "Ray tracing with rope trees", 1998; moved down as in Popov,
// Guenther, Seidel and Slusallek, "Stackless KD-tree traversal for high performance GPU ray
// tracing", 2007.
KdTree with_ropes(KdTree tree);

} // namespace raysteps
