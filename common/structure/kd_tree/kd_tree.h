#pragma once

#include "basics/box.h"
#include "structure/structure.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raysteps {

inline constexpr int kd_leaf = 3; // stands where a split has its axis: 0, 1 or 2
inline constexpr int no_kd_node = -1;

// An inner node parts its box at a plane: the first child takes what is below the split along the
// axis, the second what is above. A leaf lists triangles instead.
struct KdNode {
    int axis = kd_leaf;
    float split = 0.0f;
    int first_child = no_kd_node; // the second one is its neighbour: first_child + 1
    int parent = no_kd_node;
    int first_reference = 0; // of a leaf: its part of the references, [first, end)
    int end_reference = 0;
    int leaf = -1; // the number of the leaf among the leaves, in the order of the nodes
};

inline bool is_leaf(const KdNode& node) {
    return node.axis == kd_leaf;
}

// The node behind each face of a leaf: face 2 * axis is the lower one, 2 * axis + 1 the upper one.
using KdRopes = std::array<int, 6>;

// A binary tree over the boxes of space. Node 0 is the root; a parent stands before its children.
// A triangle is listed in each leaf whose box, grown by the padding, it overlaps: so a leaf may
// list none, and a triangle may be listed in many. A leaf lists its triangles in ascending order.
struct KdTree {
    std::vector<KdNode> nodes;
    std::vector<Box> boxes; // of each node; the root's is that of all triangles, padded
    std::vector<int> references;
    std::vector<KdRopes> ropes; // of each leaf; no_kd_node where the face is the root's own
    double padding = 0.0;
};

// Bytes of the tree as the kernels read it: 16 a node, 32 a box, 24 a leaf's ropes, 4 a reference.
inline std::size_t bytes_of(const KdTree& tree) {
    return 16 * tree.nodes.size() + 32 * tree.boxes.size() + 24 * tree.ropes.size() +
           4 * tree.references.size();
}

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
    double empty_bonus = 0.2; // discount for a split that cuts off empty space
    int leaf_triangles = 2;   // a node with no more is not split
    int depth_limit = -1;     // of a leaf, the root being at 0; below 0, 8 + 1.3 log2 n
    int bad_splits = 0; // in a row that may not pay by themselves, in the hope of a better one
    float reach = 0.0f; // see usual_reach in structure/padding.h
    // Of more triangles in all, nodes with more than `most_sorted` are split by bins: to sort
    // millions of events takes most of the time, and finds hardly better planes.
    std::size_t binned_above = 1'000'000;
    std::size_t most_sorted = 256;
    std::size_t most_bytes = std::size_t{4} << 30;                       // of the finished tree
    std::int64_t most_texels = std::numeric_limits<std::int32_t>::max(); // of each of its arrays
    unsigned threads = 0; // that build it; 0: as many as the machine has cores
};

struct KdMeasures {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t empty_leaves = 0;
    std::size_t longest_leaf = 0; // in references
    std::size_t references = 0;
    int depth = 0;     // of the deepest leaf, the root being at 0
    double cost = 0.0; // what the surface-area heuristic expects of a ray through the root's box
    std::size_t bytes = 0;
};

// The tree is that of build_kd_tree; of the options, only the costs matter.
KdMeasures measure_kd_tree(const KdTree& tree, const KdOptions& options);

// The tree under the names and in the form of shaders/structure/kd_tree/kd_nodes.glsl.
PackedStructure pack(const KdTree& tree);

} // namespace raysteps
