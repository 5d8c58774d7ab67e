#include "structure/bvh/box_tree.h"

#include <algorithm>

namespace raysteps {

namespace {} // namespace

std::span<const std::int32_t> children_of(const BoxTree& tree, std::size_t node) {
    const auto width = static_cast<std::size_t>(tree.width);
    return std::span(tree.children).subspan(width * node, width);
}

bool is_leaf(const BoxTree& tree, std::size_t node) {
    return std::ranges::all_of(children_of(tree, node),
                               [](std::int32_t child) { return child == no_child; });
}

BoxTree box_tree_of(const Bvh& bvh) {
    BoxTree tree;
    tree.nodes = bvh.nodes;
    tree.order = bvh.order;
    tree.padding = bvh.padding;
    tree.children.assign(2 * bvh.nodes.size(), no_child);
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        if (!is_leaf(bvh.nodes[i])) {
            tree.children[2 * i] = bvh.nodes[i].first;
            tree.children[2 * i + 1] = bvh.nodes[i].first + 1;
        }
    }
    return tree;
}

BoxTree box_tree_of(const Bvh4& bvh) {
    BoxTree tree;
    tree.width = bvh4_width;
    tree.order = bvh.order;
    tree.padding = bvh.padding;
    if (bvh.parents.empty()) {
        return tree;
    }
    std::vector<std::int32_t> places(bvh.children.size(), no_child); // of the children, as nodes
    tree.nodes.emplace_back();
    for (std::size_t i = 0; i < bvh.children.size(); ++i) {
        const BvhNode& child = bvh.children[i];
        if (i < bvh4_width) {
            tree.nodes[0].box = merge(tree.nodes[0].box, child.box);
        }
        if (is_leaf(child) || child.first != no_bvh4_node) {
            places[i] = static_cast<std::int32_t>(tree.nodes.size());
            tree.nodes.push_back(is_leaf(child) ? child : BvhNode{child.box, 0, 0});
        }
    }
    tree.children.assign(bvh4_width * tree.nodes.size(), no_child);
    for (std::size_t node = 0; node < bvh.parents.size(); ++node) {
        const std::int32_t parent = bvh.parents[node];
        const std::size_t own = parent == no_bvh4_node ? 0 : place_of(places[place_of(parent)]);
        std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(bvh4_width * node), bvh4_width,
                    tree.children.begin() + static_cast<std::ptrdiff_t>(bvh4_width * own));
    }
    return tree;
}

} // namespace raysteps
