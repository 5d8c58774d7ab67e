#pragma once

#include "structure/bvh/bvh.h"

#include <vector>

namespace raysteps {

// A hierarchy of boxes with up to four children a node. Node 0 is the root, and nodes stand behind
// their parent; of no triangle there is no node.
//
// Node n has the children [4n, 4n + 4), each with its box: a leaf as in a Bvh, or an inner one,
// whose `first` is the node that holds its own children. Of an empty place, count is 0 and `first`
// is no_bvh4_node; such places stand behind the others.
struct Bvh4 {
    std::vector<BvhNode> children;
    std::vector<std::int32_t> parents; // node n is the child parents[n]; of the root: no_bvh4_node
    std::vector<std::int32_t> order;
    double padding = 0.0;
    int leaf_triangles = 1; // no leaf has more
};

inline constexpr int bvh4_width = 4;
inline constexpr std::int32_t no_bvh4_node = -1;

// The same leaves under fewer nodes: of the two children of a binary node, the inner one with the
// largest surface gives way to its own two, until there are four. In time linear in the nodes.
// Source: Wald, Benthin and Boulos, "Getting Rid of Packets - Efficient SIMD Single-Ray Traversal
// using Multi-Branching BVHs", 2008.
Bvh4 collapse(const Bvh& bvh);

// As measure_bvh: to visit a node costs one step, however many children it has. The bytes are those
// of the nodes as they are packed, and of the order.
BvhMeasures measure_bvh4(const Bvh4& bvh, const BvhOptions& options);

// The tree over the triangles with these corners, three a triangle, in the form of
// shaders/structure/bvh/bvh4_nodes.glsl: 128 bytes a node, which serve all directions, and 48 a
// triangle. Throws InputError where there are more than 2^27 nodes: the first texel of one must fit
// into an integer.
PackedStructure pack(const Bvh4& bvh, std::span<const glm::vec3> corners);

} // namespace raysteps
