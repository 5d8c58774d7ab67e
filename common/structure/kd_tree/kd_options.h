#pragma once

#include <cstddef>

namespace raysteps {

enum class KdSplit {
    area,   // where the surface-area heuristic sees the least cost
    median, // in the middle of the longest side
};

// What a kd-tree is built for. The costs are those of one step down and of one triangle test, in
// one unit: only their ratio matters.
struct KdOptions {
    KdSplit split = KdSplit::area;
    double traversal_cost = 1.0;
    double intersection_cost = 1.5;
    double empty_bonus = 0.2; // by this part a split is cheaper that cuts off empty space
    int leaf_triangles = 2;   // so many triangles are never split
    int depth_limit = -1;     // of a leaf, the root being at 0; below 0, 8 + 1.3 log2 n
    int bad_splits = 0; // in a row that may not pay by themselves, in the hope of a better one
    float reach = 0.0f; // see usual_reach in structure/padding.h
    std::size_t most_bytes = std::size_t{4} << 30; // of the finished tree
    unsigned threads = 0; // that build it; 0: as many as the machine has cores
};

} // namespace raysteps
