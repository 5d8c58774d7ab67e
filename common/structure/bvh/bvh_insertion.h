#pragma once

#include "structure/bvh_item.h"
#include "structure/bvh_options.h"

#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

inline constexpr std::int32_t no_insertion_node = -1;

// A node of the tree that grows by insertion: a leaf has one item, an inner node two children
// anywhere among the nodes.
struct InsertionNode {
    Box box;
    std::int32_t parent = no_insertion_node;
    std::int32_t first_child = no_insertion_node;
    std::int32_t second_child = no_insertion_node;
    std::int32_t item = -1; // the place among the items; of an inner node -1
    std::int32_t count = 1; // of the items below
};

inline bool is_leaf(const InsertionNode& node) {
    return node.item >= 0;
}

struct InsertionTree {
    std::vector<InsertionNode> nodes;
    std::int32_t root = no_insertion_node;
};

// Inserts the items one after the other, each where it adds least to the cost of the tree, the sum
// of the surface areas of all inner nodes. The search goes down from the root, always into the
// child whose area grows least, but no deeper than depth_limit. Of equal places it takes the lower
// one, and of equal children the one with fewer items, so that copies make no chain. The tree may
// become as deep as there are items.
// Source: Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", 1987.
// There, a node may have many children, and a new item may become one more; here every inner node
// has two, and a new item becomes the sibling of a node on its way.
InsertionTree insert_all(std::span<const BvhItem> items, const BvhOptions& options);

} // namespace raysteps
