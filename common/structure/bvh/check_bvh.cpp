#include "structure/bvh/check_bvh.h"

#include "structure/padding.h"

#include <algorithm>

namespace raysteps {

namespace {

using Faults = std::vector<std::string>;

constexpr std::size_t most_faults = 10;

std::string at_node(std::size_t node, const std::string& fault) {
    return "Node " + std::to_string(node) + " " + fault;
}

bool holds(const Box& outer, const Box& inner) { // false where a bound is not a number
    bool all = true;
    for (int axis = 0; axis < 3; ++axis) {
        all =
            all && outer.lower[axis] <= inner.lower[axis] && inner.upper[axis] <= outer.upper[axis];
    }
    return all;
}

Faults faults_of_links(const Bvh& bvh) {
    Faults faults;
    std::vector<int> arrivals(bvh.nodes.size(), 0);
    arrivals[0] = 1; // at the root, from outside
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        if (is_leaf(node)) {
            continue;
        }
        if (node.count < 0 || node.first <= static_cast<std::int64_t>(i) ||
            static_cast<std::size_t>(node.first) + 1 >= bvh.nodes.size()) {
            faults.push_back(at_node(i, "has children that do not stand behind it."));
            continue;
        }
        ++arrivals[static_cast<std::size_t>(node.first)];
        ++arrivals[static_cast<std::size_t>(node.first) + 1];
    }
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
        if (arrivals[i] != 1) {
            faults.push_back(
                at_node(i, "is reached " + std::to_string(arrivals[i]) + " times, not once."));
        }
    }
    return faults;
}

// What the two trees have in common: nodes in one list (the children of all, where there are four a
// node), and the triangles of those that are leaves.
struct Leaves {
    std::span<const BvhNode> nodes;
    std::span<const std::int32_t> order;
    int leaf_triangles;
    double padding;
    std::string (*at)(std::size_t place, const std::string& fault);
};

Faults faults_of_leaves(const Leaves& leaves, std::size_t triangles) {
    Faults faults;
    std::vector<int> listed(triangles, 0);
    for (std::size_t i = 0; i < leaves.nodes.size(); ++i) {
        const BvhNode& node = leaves.nodes[i];
        if (!is_leaf(node)) {
            continue;
        }
        if (node.count > leaves.leaf_triangles) {
            faults.push_back(leaves.at(i, "is a leaf of more than " +
                                              std::to_string(leaves.leaf_triangles) +
                                              " triangles."));
        }
        const std::int64_t end = std::int64_t{node.first} + node.count;
        if (node.first < 0 || end > static_cast<std::int64_t>(leaves.order.size())) {
            faults.push_back(leaves.at(i, "has triangles outside the order."));
            continue;
        }
        std::int64_t last = -1;
        for (auto place = static_cast<std::size_t>(node.first);
             place < static_cast<std::size_t>(end); ++place) {
            const std::int64_t triangle = leaves.order[place];
            if (triangle <= last || triangle >= static_cast<std::int64_t>(triangles)) {
                faults.push_back(leaves.at(i, "lists its triangles out of order or out of range."));
                break;
            }
            last = triangle;
            ++listed[static_cast<std::size_t>(triangle)];
        }
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        if (listed[i] != 1) {
            faults.push_back("Triangle " + std::to_string(i) + " is listed " +
                             std::to_string(listed[i]) + " times, not once.");
        }
    }
    return faults;
}

// Only where faults_of_leaves has none, so that all places are known to be inside.
Faults faults_of_leaf_boxes(const Leaves& leaves, std::span<const glm::vec3> corners) {
    Faults faults;
    for (std::size_t i = 0; i < leaves.nodes.size(); ++i) {
        const BvhNode& node = leaves.nodes[i];
        const auto first = static_cast<std::size_t>(node.first);
        for (std::size_t place = first; place < first + static_cast<std::size_t>(node.count);
             ++place) {
            const auto triangle = static_cast<std::size_t>(leaves.order[place]);
            const Box padded = pad(bounds_of(corners.subspan(3 * triangle, 3)), leaves.padding);
            if (!holds(node.box, padded)) {
                faults.push_back(
                    leaves.at(i, "does not hold triangle " + std::to_string(triangle) + "."));
            }
        }
    }
    return faults;
}

Faults faults_of_inner_boxes(const Bvh& bvh) {
    Faults faults;
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        const auto first = static_cast<std::size_t>(node.first);
        if (!is_leaf(node) &&
            !(holds(node.box, bvh.nodes[first].box) && holds(node.box, bvh.nodes[first + 1].box))) {
            faults.push_back(at_node(i, "does not hold the boxes of its children."));
        }
    }
    return faults;
}

std::string at_child(std::size_t place, const std::string& fault) {
    return "Child " + std::to_string(place % bvh4_width) + " of node " +
           std::to_string(place / bvh4_width) + " " + fault;
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

Faults faults_of_inner_boxes(const Bvh4& bvh) {
    Faults faults;
    for (std::size_t i = 1; i < bvh.parents.size(); ++i) {
        const auto own = static_cast<std::size_t>(bvh.parents[i]);
        for (std::size_t place = bvh4_width * i; place < bvh4_width * (i + 1); ++place) {
            const BvhNode& child = bvh.children[place];
            if (!is_empty_place(child) && !holds(bvh.children[own].box, child.box)) {
                faults.push_back(at_child(own, "does not hold the boxes of its children."));
                break;
            }
        }
    }
    return faults;
}

// The checks of either tree, one after the other, as far as they make sense.
template <class Tree>
Faults faults_of(const Tree& tree, const Leaves& leaves, std::span<const glm::vec3> corners) {
    const std::size_t triangles = corners.size() / 3;
    if (leaves.order.size() != triangles || leaves.nodes.empty() != (triangles == 0)) {
        return {"A tree has each triangle once in its order, and a root unless there is none."};
    }
    if (triangles == 0) {
        return {};
    }
    if (!(leaves.padding >= padding_for(usual_reach(bounds_of(corners), 0.0)))) {
        return {"The padding is less than rays from around the scene need."};
    }
    Faults faults = faults_of_links(tree);
    if (faults.empty()) {
        faults = faults_of_leaves(leaves, triangles);
    }
    if (faults.empty()) {
        faults = faults_of_inner_boxes(tree);
        const Faults more = faults_of_leaf_boxes(leaves, corners);
        faults.insert(faults.end(), more.begin(), more.end());
    }
    faults.resize(std::min(faults.size(), most_faults));
    return faults;
}

} // namespace

std::vector<std::string> check_bvh(const Bvh& bvh, std::span<const glm::vec3> corners) {
    return faults_of(bvh, {bvh.nodes, bvh.order, bvh.leaf_triangles, bvh.padding, at_node},
                     corners);
}

std::vector<std::string> check_bvh4(const Bvh4& bvh, std::span<const glm::vec3> corners) {
    if (bvh.children.size() != bvh4_width * bvh.parents.size()) {
        return {"A tree has four places for children a node."};
    }
    return faults_of(bvh, {bvh.children, bvh.order, bvh.leaf_triangles, bvh.padding, at_child},
                     corners);
}

} // namespace raysteps
