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

Faults faults_of_leaves(const Bvh& bvh, std::size_t triangles) {
    Faults faults;
    std::vector<int> listed(triangles, 0);
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        if (!is_leaf(node)) {
            continue;
        }
        if (node.count > bvh.leaf_triangles) {
            faults.push_back(at_node(i, "is a leaf of more than " +
                                            std::to_string(bvh.leaf_triangles) + " triangles."));
        }
        const std::int64_t end = std::int64_t{node.first} + node.count;
        if (node.first < 0 || end > static_cast<std::int64_t>(bvh.order.size())) {
            faults.push_back(at_node(i, "has triangles outside the order."));
            continue;
        }
        std::int64_t last = -1;
        for (auto place = static_cast<std::size_t>(node.first);
             place < static_cast<std::size_t>(end); ++place) {
            const std::int64_t triangle = bvh.order[place];
            if (triangle <= last || triangle >= static_cast<std::int64_t>(triangles)) {
                faults.push_back(at_node(i, "lists its triangles out of order or out of range."));
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

Faults faults_of_boxes(const Bvh& bvh, std::span<const glm::vec3> corners) {
    Faults faults;
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        const auto first = static_cast<std::size_t>(node.first);
        if (!is_leaf(node) &&
            !(holds(node.box, bvh.nodes[first].box) && holds(node.box, bvh.nodes[first + 1].box))) {
            faults.push_back(at_node(i, "does not hold the boxes of its children."));
        }
        for (std::size_t place = first; place < first + static_cast<std::size_t>(node.count);
             ++place) {
            const auto triangle = static_cast<std::size_t>(bvh.order[place]);
            if (!holds(node.box, pad(bounds_of(corners.subspan(3 * triangle, 3)), bvh.padding))) {
                faults.push_back(
                    at_node(i, "does not hold triangle " + std::to_string(triangle) + "."));
            }
        }
    }
    return faults;
}

} // namespace

std::vector<std::string> check_bvh(const Bvh& bvh, std::span<const glm::vec3> corners) {
    const std::size_t triangles = corners.size() / 3;
    if (bvh.order.size() != triangles || bvh.nodes.empty() != (triangles == 0)) {
        return {"A tree has each triangle once in its order, and a root unless there is none."};
    }
    if (triangles == 0) {
        return {};
    }
    if (!(bvh.padding >= padding_for(usual_reach(bounds_of(corners), 0.0)))) {
        return {"The padding is less than rays from around the scene need."};
    }
    Faults faults = faults_of_links(bvh);
    if (faults.empty()) {
        faults = faults_of_leaves(bvh, triangles);
    }
    if (faults.empty()) { // only now all places are known to be inside
        faults = faults_of_boxes(bvh, corners);
    }
    faults.resize(std::min(faults.size(), most_faults));
    return faults;
}

} // namespace raysteps
