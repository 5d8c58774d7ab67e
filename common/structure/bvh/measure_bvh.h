#pragma once

#include "structure/bvh.h"
#include "structure/bvh_options.h"

namespace raysteps {

struct BvhMeasures {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t longest_leaf = 0; // in triangles
    int depth = 0;                // of the deepest leaf, the root being at 0
    double cost = 0.0;
    std::size_t bytes = 0;
};

// The tree is one that check_bvh finds right; of the options, only the costs matter. Of no triangle
// all is 0.
//
// The cost is what a ray through the root's box is expected to cost. A ray that hits a box p, all
// of them being equally likely, hits a convex box c inside it with the probability
//   p(hit c | hit p) = S_c / S_p,
// the ratio of their surfaces. Along the path to a node the S between cancel, so that the node is
// met with the probability S_node / S_root. There an inner node costs a step, and a leaf the tests
// of its triangles:
//   cost = traversal_cost * sum of S_inner / S_root
//        + intersection_cost * sum of S_leaf / S_root * count.
// It knows nothing of rays that start inside, or end at the first hit.
// Source: Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", 1987.
BvhMeasures measure_bvh(const Bvh& bvh, const BvhOptions& options);

} // namespace raysteps
