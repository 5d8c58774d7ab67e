#pragma once

#include "structure/bvh/bvh.h"
#include "structure/bvh/bvh4.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace raysteps {

inline constexpr std::int32_t no_child = -1;
// Stands for a number of a file that no node and no triangle can have.
inline constexpr std::int32_t far_out = std::numeric_limits<std::int32_t>::max();

// Any hierarchy of boxes, of whoever built it: nothing is known of it to be right. Node 0 is the
// root. Node n has the children [width * n, width * (n + 1)), of which no_child are none; without
// any it is a leaf and has the triangles order[first, first + count).
struct BoxTree {
    int width = 2;
    std::vector<BvhNode> nodes;
    std::vector<std::int32_t> children;
    std::vector<std::int32_t> order;
    std::vector<std::int32_t> gaps; // nodes that the builder leaves unused
    bool splits = false;  // a triangle may be in several leaves, whose boxes cover it together
    double padding = 0.0; // as of a Bvh; 0 where boxes are tight
};

// Where a number of the file that is not negative stands in an array.
inline std::size_t place_of(std::int32_t number) {
    return static_cast<std::size_t>(number);
}

inline bool is_child(const BoxTree& tree, std::int32_t child) {
    return child >= 0 && place_of(child) < tree.nodes.size();
}

std::span<const std::int32_t> children_of(const BoxTree& tree, std::size_t node);
bool is_leaf(const BoxTree& tree, std::size_t node);

// Of leaves that share the same part of the order, so many triangles together are looked at.
inline std::size_t most_references(const BoxTree& tree) {
    return 4 * tree.order.size() + 1024;
}

// The same hierarchy. A node of four has its box from its parent, and the root that of all.
BoxTree box_tree_of(const Bvh& bvh);
BoxTree box_tree_of(const Bvh4& bvh);

// The tree as our walks have it; box_tree_of gives the same nodes again. Of up to two children a
// node, and of up to four. Throws InputError where no walk could end in it, or the number of
// children does not fit: what find_faults has of links and ranges. Lost triangles and short boxes
// pass: they are to be seen.
Bvh bvh_of(const BoxTree& tree, std::size_t triangles);
Bvh4 bvh4_of(const BoxTree& tree, std::size_t triangles);

struct BoxTreeMeasures {
    BvhMeasures tree; // the cost as of measure_bvh; the bytes of 32 a node and 4 a reference
    // The sum over all pairs of siblings of the surface of what their boxes have in common, over
    // that of the root's: so many visits more a random ray makes because siblings overlap.
    double overlap = 0.0;
    // The part of an inner node's volume that is in no child's box: the mean over all of them, each
    // by its surface, which is how often it is met.
    double empty_space = 0.0;
    std::map<std::size_t, std::size_t> leaves_of_size; // by the number of triangles
};

// Of what can be reached from the root, each node once; where nothing can, all is 0.
BoxTreeMeasures measure_box_tree(const BoxTree& tree, const BvhOptions& options);

} // namespace raysteps
