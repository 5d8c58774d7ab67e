#pragma once

#include "geometry/box.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raysteps {

// A leaf has count > 0 and owns the triangles order[first, first + count). An inner node has
// count == 0, and its children are the nodes first and first + 1.
struct BvhNode {
    Box box;
    std::int32_t first = 0;
    std::int32_t count = 0;
};

inline bool is_leaf(const BvhNode& node) {
    return node.count > 0;
}

// A bounding volume hierarchy: a binary tree over the triangles themselves. Node 0 is the root, and
// children stand behind their parent. Of no triangle there is no node. The order is a permutation
// of all triangles; a leaf has its own in ascending order. A box holds its children's boxes, and
// those of its triangles grown by the padding (structure/padding.h). Boxes may overlap.
struct Bvh {
    std::vector<BvhNode> nodes;
    std::vector<std::int32_t> order;
    double padding = 0.0;
    int leaf_triangles = 1; // no leaf has more
};

// Bytes of nodes and order: 32 a node, 4 a triangle.
inline std::size_t bytes_of(const Bvh& bvh) {
    return sizeof(BvhNode) * bvh.nodes.size() + sizeof(std::int32_t) * bvh.order.size();
}

} // namespace raysteps
