#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <numeric>
#include <random>

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

namespace {

InsertionNode& node_at(InsertionTree& tree, std::int32_t place) {
    return tree.nodes[static_cast<std::size_t>(place)];
}

const InsertionNode& node_at(const InsertionTree& tree, std::int32_t place) {
    return tree.nodes[static_cast<std::size_t>(place)];
}

double growth_of(const Box& box, const Box& added) {
    return surface_area(merge(box, added)) - surface_area(box);
}

// The child whose area grows least.
std::int32_t way_down(const InsertionTree& tree, const InsertionNode& node, const Box& box) {
    const InsertionNode& first = node_at(tree, node.first_child);
    const InsertionNode& second = node_at(tree, node.second_child);
    const double first_growth = growth_of(first.box, box);
    const double second_growth = growth_of(second.box, box);
    const bool take_first =
        first_growth != second_growth ? first_growth < second_growth : first.count <= second.count;
    return take_first ? node.first_child : node.second_child;
}

// The node whose sibling the box should become.
std::int32_t best_sibling(const InsertionTree& tree, const Box& box, int depth_limit) {
    std::int32_t node = tree.root;
    std::int32_t best = node;
    double best_cost = surface_area(merge(node_at(tree, node).box, box));
    double inherited = 0.0; // by how much the areas on the way have grown
    for (int depth = 0; depth < depth_limit && !is_leaf(node_at(tree, node)); ++depth) {
        inherited += growth_of(node_at(tree, node).box, box);
        if (inherited + surface_area(box) > best_cost) {
            break; // further down, what is inherited only grows
        }
        node = way_down(tree, node_at(tree, node), box);
        const double cost = inherited + surface_area(merge(node_at(tree, node).box, box));
        if (cost <= best_cost) {
            best = node;
            best_cost = cost;
        }
    }
    return best;
}

// A new inner node takes the sibling's place, over the sibling and a new leaf.
InsertionTree inserted(InsertionTree tree, std::int32_t sibling, std::int32_t item,
                       const Box& box) {
    const auto leaf = static_cast<std::int32_t>(tree.nodes.size());
    const std::int32_t inner = leaf + 1;
    const std::int32_t parent = node_at(tree, sibling).parent;
    tree.nodes.push_back({box, inner, no_insertion_node, no_insertion_node, item, 1});
    tree.nodes.push_back(
        {node_at(tree, sibling).box, parent, sibling, leaf, -1, node_at(tree, sibling).count});
    node_at(tree, sibling).parent = inner;
    if (parent == no_insertion_node) {
        tree.root = inner;
    } else if (node_at(tree, parent).first_child == sibling) {
        node_at(tree, parent).first_child = inner;
    } else {
        node_at(tree, parent).second_child = inner;
    }
    for (std::int32_t node = inner; node != no_insertion_node; node = node_at(tree, node).parent) {
        node_at(tree, node).box = merge(node_at(tree, node).box, box);
        ++node_at(tree, node).count;
    }
    return tree;
}

std::vector<std::int32_t> insertion_order(std::size_t count, const BvhOptions& options) {
    std::vector<std::int32_t> places(count);
    std::iota(places.begin(), places.end(), 0);
    if (options.insertion_order == InsertionOrder::as_given) {
        return places;
    }
    // Fisher and Yates, by hand, since std::shuffle gives another order with another library.
    std::mt19937 numbers(static_cast<std::uint32_t>(options.seed));
    for (std::size_t i = count; i > 1; --i) {
        std::swap(places[i - 1], places[numbers() % i]);
    }
    return places;
}

} // namespace

InsertionTree insert_all(std::span<const BvhItem> items, const BvhOptions& options) {
    InsertionTree tree;
    if (items.empty()) {
        return tree;
    }
    tree.nodes.reserve(2 * items.size());
    const std::vector<std::int32_t> order = insertion_order(items.size(), options);
    InsertionNode root;
    root.box = items[static_cast<std::size_t>(order.front())].box;
    root.item = order.front();
    tree.nodes.push_back(root);
    tree.root = 0;
    for (const std::int32_t item : std::span(order).subspan(1)) {
        const Box& box = items[static_cast<std::size_t>(item)].box;
        const std::int32_t sibling = best_sibling(tree, box, options.depth_limit);
        tree = inserted(std::move(tree), sibling, item, box);
    }
    return tree;
}

} // namespace raysteps
