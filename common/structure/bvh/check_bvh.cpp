#include "structure/bvh/check_bvh.h"

#include "structure/bvh/find_faults.h"
#include "structure/padding.h"

#include <algorithm>

namespace raysteps {

namespace {

using Faults = std::vector<std::string>;

std::string at_node(std::size_t node, const std::string& fault) {
    return "Node " + std::to_string(node) + " " + fault;
}

std::string at_child(std::size_t place, const std::string& fault) {
    return "Child " + std::to_string(place % bvh4_width) + " of node " +
           std::to_string(place / bvh4_width) + " " + fault;
}

// What our builders promise of links beside what find_faults has.

Faults faults_of_links(const Bvh& bvh) {
    Faults faults;
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        if (!is_leaf(node) && (node.count < 0 || node.first <= static_cast<std::int64_t>(i) ||
                               static_cast<std::size_t>(node.first) + 1 >= bvh.nodes.size())) {
            faults.push_back(at_node(i, "has children that do not stand behind it."));
        }
    }
    return faults;
}

bool is_empty_place(const BvhNode& child) {
    return child.count == 0 && child.first == no_bvh4_node;
}

Faults faults_of_links(const Bvh4& bvh) {
    Faults faults;
    std::vector<int> arrivals(bvh.parents.size(), 0);
    ++arrivals[0]; // at the root, from outside
    if (bvh.parents[0] != no_bvh4_node) {
        faults.push_back(at_node(0, "is the root, and names a parent."));
    }
    for (std::size_t i = 0; i < bvh.children.size(); ++i) {
        const BvhNode& child = bvh.children[i];
        const bool is_first = i % bvh4_width == 0;
        if (is_empty_place(child)) {
            if (is_first) {
                faults.push_back(at_node(i / bvh4_width, "has no first child."));
            }
            continue;
        }
        if (!is_first && is_empty_place(bvh.children[i - 1])) {
            faults.push_back(at_child(i, "stands behind an empty place."));
        }
        if (is_leaf(child)) {
            continue;
        }
        if (child.count < 0 || child.first <= static_cast<std::int64_t>(i / bvh4_width) ||
            static_cast<std::size_t>(child.first) >= bvh.parents.size()) {
            faults.push_back(at_child(i, "leads to a node that does not stand behind it."));
            continue;
        }
        const auto node = static_cast<std::size_t>(child.first);
        ++arrivals[node];
        if (bvh.parents[node] != static_cast<std::int64_t>(i)) {
            faults.push_back(at_node(node, "names another parent than the one it has."));
        }
    }
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
        if (arrivals[i] != 1) {
            faults.push_back(
                at_node(i, "is reached " + std::to_string(arrivals[i]) + " times, not once."));
        }
    }
    return faults;
}

// And of leaves, where find_faults has found nothing.
Faults faults_of_leaves(const BoxTree& tree, int leaf_triangles) {
    Faults faults;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BvhNode& node = tree.nodes[i];
        if (!is_leaf(tree, i)) {
            continue;
        }
        if (node.count > leaf_triangles) {
            faults.push_back(at_node(i, "is a leaf of more than " + std::to_string(leaf_triangles) +
                                            " triangles."));
        }
        const auto own = std::span(tree.order)
                             .subspan(static_cast<std::size_t>(node.first),
                                      static_cast<std::size_t>(node.count));
        if (!std::ranges::is_sorted(own)) {
            faults.push_back(at_node(i, "lists its triangles out of order."));
        }
    }
    return faults;
}

template <class Tree>
Faults faults_of(const Tree& tree, bool is_empty, std::span<const glm::vec3> corners) {
    const std::size_t triangles = corners.size() / 3;
    if (tree.order.size() != triangles || is_empty != (triangles == 0)) {
        return {"A tree has each triangle once in its order, and a root unless there is none."};
    }
    if (triangles == 0) {
        return {};
    }
    if (!(tree.padding >= padding_for(usual_reach(bounds_of(corners), 0.0)))) {
        return {"The padding is less than rays from around the scene need."};
    }
    Faults faults = faults_of_links(tree);
    if (!faults.empty()) {
        return faults;
    }
    const BoxTree boxes = box_tree_of(tree);
    const TreeFindings found = find_faults(boxes, corners, tree.padding);
    faults = sentences_of(found.faults);
    const Faults tight = sentences_of(found.remarks);
    faults.insert(faults.end(), tight.begin(), tight.end());
    return faults.empty() ? faults_of_leaves(boxes, tree.leaf_triangles) : faults;
}

} // namespace

std::vector<std::string> check_bvh(const Bvh& bvh, std::span<const glm::vec3> corners) {
    return faults_of(bvh, bvh.nodes.empty(), corners);
}

std::vector<std::string> check_bvh4(const Bvh4& bvh, std::span<const glm::vec3> corners) {
    if (bvh.children.size() != bvh4_width * bvh.parents.size()) {
        return {"A tree has four places for children a node."};
    }
    return faults_of(bvh, bvh.parents.empty(), corners);
}

} // namespace raysteps
