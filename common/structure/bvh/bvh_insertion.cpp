#include "structure/bvh_insertion.h"

#include <numeric>
#include <random>

namespace raysteps {

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
