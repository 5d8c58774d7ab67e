#pragma once

#include "basics/box.h"
#include "structure/bvh/bvh.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace raysteps {

// A triangle as a builder sees it: its box, padded, and its number.
struct BvhItem {
    Box box;
    std::int32_t triangle = 0;
};

// Twice the centre of the item's box along the axis. Only the order of centres matters, and that of
// their doubles is the same.
inline float doubled_center(const BvhItem& item, int axis) {
    return item.box.lower[axis] + item.box.upper[axis];
}

inline glm::vec3 doubled_center(const BvhItem& item) {
    return item.box.lower + item.box.upper;
}

// Four numbers that one instruction computes with (g++ and clang++ have such types).
using FourFloats = float __attribute__((vector_size(16)));

// A box with a fourth axis that nobody asks for. Builders spend most of their time merging boxes,
// and four axes at once are merged sooner than three one by one.
struct WideBox {
    FourFloats lower;
    FourFloats upper;
};

inline WideBox empty_wide_box() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {FourFloats{+infinity, +infinity, +infinity, +infinity},
            FourFloats{-infinity, -infinity, -infinity, -infinity}};
}

// The box of an item; on the fourth axis stands what comes next in memory.
inline WideBox wide_box_of(const BvhItem& item) {
    static_assert(std::is_trivially_copyable_v<BvhItem> && sizeof(Box) == 6 * sizeof(float) &&
                  sizeof(BvhItem) == 7 * sizeof(float));
    const auto* const bytes = reinterpret_cast<const std::byte*>(&item);
    WideBox box; // every number is set
    std::memcpy(&box.lower, bytes, sizeof(box.lower));
    std::memcpy(&box.upper, bytes + sizeof(glm::vec3), sizeof(box.upper));
    return box;
}

inline Box narrow(const WideBox& box) {
    return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

inline WideBox merge(const WideBox& a, const WideBox& b) {
    return {b.lower < a.lower ? b.lower : a.lower, b.upper > a.upper ? b.upper : a.upper};
}

// Twice the centre: see doubled_center.
inline FourFloats doubled_center(const WideBox& box) {
    return box.lower + box.upper;
}

// The surface of a box that is not empty.
inline double surface_area(const WideBox& box) {
    return surface_between(box.lower, box.upper);
}

// The items of a node that is to be split, two at least, with the box around them and the box
// around their doubled centres.
struct BvhRange {
    std::span<const BvhItem> items;
    Box box;
    Box centers;
};

// Of the items in the order of their centres along the axis (of equal centres, the smaller triangle
// first), the first lower_count go to the first child: one at least, and not all. The cost is that
// of the split node for a ray that meets it; infinite where the rule knows no cost. Where all
// centres of the first child are less than those of the second, a rule may say what the latter
// begin with: then parting them takes one look at each.
struct BvhCut {
    int axis = 0;
    std::size_t lower_count = 0;
    double cost = std::numeric_limits<double>::infinity();
    std::optional<float> first_upper_center{}; // doubled
};

// A rule answers where a range is best cut; nothing where equal centres tell it nothing.
using BvhRule = std::optional<BvhCut> (*)(const BvhRange& range, const BvhOptions& options);

// What a ray that meets the range is expected to cost if it is split. A ray that meets a box with
// the surface S meets a box inside with the probability S_lower / S (see measure_bvh), so this is
//   traversal_cost + intersection_cost * (S_lower n_lower + S_upper n_upper) / S,
// n being numbers of triangles; `weighted` is the sum in brackets.
// Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990.
inline double split_cost(double weighted, const BvhRange& range, const BvhOptions& options) {
    return options.traversal_cost + options.intersection_cost * weighted / surface_area(range.box);
}

// The axis along which the box is longest; of equal lengths the first.
inline int longest_axis(const Box& box) {
    int longest = 0;
    double length = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double own =
            static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
        if (own > length) {
            longest = axis;
            length = own;
        }
    }
    return longest;
}

// Half of the items on each side, along the axis on which their centres spread farthest. It knows
// no cost. Since it cuts by number and not by a plane, no side is empty, whatever the centres.
// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986.
std::optional<BvhCut> split_median(const BvhRange& range, const BvhOptions& options);

// The cut of least split_cost at one of bins - 1 equally spaced planes along each axis, in time
// linear in the items and the bins. There are options.bins of them, or four more than items where
// that is less.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007. There, only
// the longest axis is tried; here, all three are.
std::optional<BvhCut> split_binned(const BvhRange& range, const BvhOptions& options);

// The cut of least split_cost between any two items along each axis; of equal costs along one axis,
// the one nearest to the middle. It sorts the items once an axis, so that a whole tree takes
// O(n log^2 n).
// Source: Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes using Dynamic Bounding Volume
// Hierarchies", 2007.
std::optional<BvhCut> split_sweep(const BvhRange& range, const BvhOptions& options);

// The nodes of a tree over the items, which it rearranges: a leaf's part of the order is its part
// of the items. The common loop of all builders from the top down, and it recurses nowhere:
// - a range becomes a leaf where it has no more than leaf_triangles items, and either the rule
//   knows no cut or its cut costs no less than the leaf;
// - else it is cut where the rule says, or in the middle where the rule knows no cut;
// - where the rest of depth_limit only just suffices, it is cut in the middle whatever the rule
//   says, so that no leaf is deeper than depth_limit or than log2(n / leaf_triangles), rounded up.
// The depth is that of the root. On so many threads as the options say; the nodes do not depend on
// their number.
std::vector<BvhNode> grow_bvh(std::span<BvhItem> items, BvhRule rule, const BvhOptions& options,
                              int depth);

// Must a node of so many triangles at this depth be halved, or be made a leaf, to keep the
// depth_limit?
bool is_at_depth_limit(std::size_t count, int depth, const BvhOptions& options);

// The nodes with a branch in place of the given node. The branch's leaves are moved by `first` in
// the order.
std::vector<BvhNode> graft(std::vector<BvhNode> nodes, std::size_t node,
                           std::span<const BvhNode> branch, std::size_t first);

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

// The tree over the items in the form of a Bvh. A subtree of no more than leaf_triangles becomes a
// leaf where that costs no more. Where the tree grows beyond depth_limit, its items are halved from
// there on instead (see grow_bvh). Only nodes and order are filled in.
Bvh flattened(const InsertionTree& tree, std::span<const BvhItem> items, const BvhOptions& options);

} // namespace raysteps
