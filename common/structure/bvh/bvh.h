#pragma once

#include "basics/box.h"
#include "structure/structure.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
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
    int leaf_triangles = 7; // no leaf has more
    int depth_limit = 64;   // no leaf is deeper, unless it takes more to halve so many triangles
    // A node costs twice as much as a triangle test: it is two fetches from memory, and rays that
    // go side by side wait for each other at it (`./run.sh 06 --measure` shows what the costs do).
    double traversal_cost = 3.0;
    double intersection_cost = 1.5;
    double reach = 0.0;                                // see usual_reach in structure/padding.h
    std::int64_t memory_limit = std::int64_t{4} << 30; // of the finished tree, in bytes
    unsigned threads = 0; // that build it; 0: as many as the machine has cores
    InsertionOrder insertion_order = InsertionOrder::shuffled;
    int seed = 1; // of the random insertion order
};

struct BvhMeasures {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t references = 0;   // triangles in all leaves together
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

// The tree over the triangles with these corners, three a triangle, in the form of
// shaders/structure/bvh/bvh_nodes.glsl: its nodes once for each octant of directions, and the
// triangles once more in the order of the leaves. That is 256 + 4 bytes a node and 48 a triangle,
// in time linear in both. Throws InputError where the tree has more than 2^26 nodes: the place of
// one must fit into an integer beside the number of an axis.
PackedStructure pack(const Bvh& bvh, std::span<const glm::vec3> corners);

// The triangles with these corners in the order of the leaves, in the form of
// shaders/structure/bvh/bvh_leaf.glsl: three texels each. Nodes that are no leaves do not matter.
std::vector<glm::ivec4> pack_leaves(std::span<const BvhNode> nodes,
                                    std::span<const std::int32_t> order,
                                    std::span<const glm::vec3> corners);

// What the arrays of a packed structure take.
std::size_t bytes_of(const PackedStructure& packed);

// The box that all halves of a tree are shares of (shaders/structure/bvh/half_bvh.glsl).
struct HalfFrame {
    glm::vec3 lower{0.0f};
    glm::vec3 size{0.0f};
};

// The plane that the bits of a half stand for along one axis: the same sum as in the walk.
float half_plane(const HalfFrame& frame, int axis, int bits);

// The bits of the last half whose plane is not over the value, and of the first one whose plane is
// not under it. The value lies within the frame.
int half_below(const HalfFrame& frame, int axis, float value);
int half_above(const HalfFrame& frame, int axis, float value);

// A packed BVH (structure/bvh/bvh.h) in the form of shaders/structure/bvh/half_bvh.glsl: boxes in
// half precision, rounded outwards, for one order of the nodes. 16 bytes a node.
PackedStructure with_half_boxes(const PackedStructure& bvh);

} // namespace raysteps
