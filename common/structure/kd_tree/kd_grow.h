#pragma once

#include "structure/kd_events.h"
#include "structure/kd_options.h"
#include "structure/kd_tree.h"

#include <atomic>

namespace raysteps {

// What all parts of one tree have in common while it grows, on however many threads.
struct KdPlan {
    KdTriangles triangles;
    KdOptions options;
    int depth_limit = 0;
    std::atomic<std::size_t> bytes = 0; // of the leaves that are made
};

// A node that is still to be split or to become a leaf.
struct KdBud {
    int node = 0;
    Box box;
    int depth = 0;
    int bad_splits = 0; // in a row, on the way to it
    KdEvents events;
};

// A tree without ropes, and the buds that it was not to grow itself.
struct KdGrowth {
    KdTree tree;
    std::vector<KdBud> left_over;
};

// Grows a tree from the bud, which becomes node 0. Children with fewer triangles are left over.
// Throws InputError where the plan's bytes are more than its options allow.
KdGrowth grow(KdPlan& plan, KdBud bud, std::size_t fewest);

// The tree with the branch, which was grown from a bud of it, in the place of that bud's node.
KdTree graft(KdTree tree, int node, const KdTree& branch);

} // namespace raysteps
