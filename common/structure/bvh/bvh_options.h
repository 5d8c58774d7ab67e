#pragma once

#include <cstdint>

namespace raysteps {

enum class BvhSplit {
    median,    // half of the triangles on each side (Kay and Kajiya 1986)
    insertion, // one triangle after the other where it adds least area (Goldsmith and Salmon 1987)
    binned,    // the cheapest of a few planes by surface areas (Wald 2007)
    sweep,     // the cheapest of all planes between centres by surface areas
};

enum class InsertionOrder {
    shuffled,
    as_given,
};

// What a BVH is built for. The costs are those of one step down and of one triangle test, in one
// unit: only their ratio matters.
struct BvhOptions {
    BvhSplit split = BvhSplit::binned;
    int bins = 32;          // along each axis, from 2 to 256
    int leaf_triangles = 4; // no leaf has more
    int depth_limit = 64;   // no leaf is deeper, unless it takes more to halve so many triangles
    double traversal_cost = 1.0;
    double intersection_cost = 1.5;
    double reach = 0.0;                                // see usual_reach in structure/padding.h
    std::int64_t memory_limit = std::int64_t{4} << 30; // of the finished tree, in bytes
    unsigned threads = 0; // that build it; 0: as many as the machine has cores
    InsertionOrder insertion_order = InsertionOrder::shuffled;
    int seed = 1; // of the shuffle
};

} // namespace raysteps
