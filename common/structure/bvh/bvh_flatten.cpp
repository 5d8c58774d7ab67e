#include "structure/bvh_flatten.h"

#include "structure/bvh_grow.h"
#include "structure/split_median.h"

#include <algorithm>

namespace raysteps {

namespace {

std::size_t place(std::int32_t node) {
    return static_cast<std::size_t>(node);
}

// Parents before their children.
std::vector<std::int32_t> from_the_top(const InsertionTree& tree) {
    std::vector<std::int32_t> nodes{tree.root};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const InsertionNode& node = tree.nodes[place(nodes[i])];
        if (!is_leaf(node)) {
            nodes.push_back(node.first_child);
            nodes.push_back(node.second_child);
        }
    }
    return nodes;
}

// For each node, whether a leaf of all its items costs no more than the best of its subtree.
std::vector<char> worth_a_leaf(const InsertionTree& tree, const BvhOptions& options) {
    std::vector<char> worth(tree.nodes.size(), 0);
    std::vector<double> costs(tree.nodes.size(), 0.0);
    std::vector<std::int32_t> nodes = from_the_top(tree);
    std::reverse(nodes.begin(), nodes.end());
    for (const std::int32_t at : nodes) {
        const InsertionNode& node = tree.nodes[place(at)];
        const double leaf_cost = options.intersection_cost * node.count;
        costs[place(at)] = leaf_cost;
        worth[place(at)] = node.count <= options.leaf_triangles ? 1 : 0;
        if (is_leaf(node)) {
            continue;
        }
        double below = 0.0;
        for (const std::int32_t child : {node.first_child, node.second_child}) {
            below += surface_area(tree.nodes[place(child)].box) * costs[place(child)];
        }
        const double split_cost = options.traversal_cost + below / surface_area(node.box);
        if (worth[place(at)] == 0 || split_cost < leaf_cost) {
            worth[place(at)] = 0;
            costs[place(at)] = split_cost;
        }
    }
    return worth;
}

std::vector<BvhItem> items_below(const InsertionTree& tree, std::int32_t top,
                                 std::span<const BvhItem> items) {
    std::vector<BvhItem> below;
    std::vector<std::int32_t> stack{top};
    while (!stack.empty()) {
        const InsertionNode& node = tree.nodes[place(stack.back())];
        stack.pop_back();
        if (is_leaf(node)) {
            below.push_back(items[place(node.item)]);
            continue;
        }
        stack.push_back(node.second_child);
        stack.push_back(node.first_child);
    }
    return below;
}

// A node of the growing tree that becomes the node `to` of the flat one.
struct Move {
    std::int32_t from = no_insertion_node;
    std::size_t to = 0;
    int depth = 0;
};

Bvh with_leaf(Bvh bvh, const Move& move, const std::vector<BvhItem>& below) {
    BvhNode& node = bvh.nodes[move.to];
    node.first = static_cast<std::int32_t>(bvh.order.size());
    node.count = static_cast<std::int32_t>(below.size());
    for (const BvhItem& item : below) {
        node.box = merge(node.box, item.box);
        bvh.order.push_back(item.triangle);
    }
    std::sort(bvh.order.begin() + node.first, bvh.order.end());
    return bvh;
}

// The subtree halved until its leaves are small enough.
Bvh with_halves(Bvh bvh, const Move& move, std::vector<BvhItem> below, const BvhOptions& options) {
    const std::vector<BvhNode> branch = grow_bvh(below, split_median, options, move.depth);
    bvh.nodes = graft(std::move(bvh.nodes), move.to, branch, bvh.order.size());
    for (const BvhItem& item : below) {
        bvh.order.push_back(item.triangle);
    }
    return bvh;
}

} // namespace

Bvh flattened(const InsertionTree& tree, std::span<const BvhItem> items,
              const BvhOptions& options) {
    Bvh bvh;
    if (items.empty()) {
        return bvh;
    }
    const std::vector<char> worth = worth_a_leaf(tree, options);
    bvh.nodes.emplace_back();
    std::vector<Move> moves{{tree.root, 0, 0}};
    while (!moves.empty()) {
        const Move move = moves.back();
        moves.pop_back();
        const InsertionNode& node = tree.nodes[place(move.from)];
        if (worth[place(move.from)] != 0) {
            bvh = with_leaf(std::move(bvh), move, items_below(tree, move.from, items));
            continue;
        }
        if (is_at_depth_limit(static_cast<std::size_t>(node.count), move.depth, options)) {
            bvh = with_halves(std::move(bvh), move, items_below(tree, move.from, items), options);
            continue;
        }
        const std::size_t child = bvh.nodes.size();
        bvh.nodes[move.to] = {node.box, static_cast<std::int32_t>(child), 0};
        bvh.nodes.resize(child + 2);
        moves.push_back({node.second_child, child + 1, move.depth + 1});
        moves.push_back({node.first_child, child, move.depth + 1});
    }
    return bvh;
}

} // namespace raysteps
