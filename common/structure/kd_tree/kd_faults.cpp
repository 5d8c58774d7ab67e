#include "structure/kd_faults.h"

#include "structure/kd_plane.h"

namespace raysteps {

namespace {

std::string at_node(std::size_t node, const std::string& fault) {
    return "Node " + std::to_string(node) + " " + fault;
}

std::size_t place(int node) {
    return static_cast<std::size_t>(node);
}

} // namespace

KdFaults faults_of_links(const KdTree& tree) {
    if (tree.nodes.empty() || tree.boxes.size() != tree.nodes.size()) {
        return {"A tree needs a root, and a box for each node."};
    }
    KdFaults faults;
    std::vector<int> arrivals(tree.nodes.size(), 0);
    arrivals[0] = tree.nodes[0].parent == no_kd_node ? 1 : 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode& node = tree.nodes[i];
        if (is_leaf(node)) {
            continue;
        }
        if (node.axis < 0 || node.axis > 2 || node.first_child <= static_cast<int>(i) ||
            place(node.first_child) + 1 >= tree.nodes.size()) {
            return {at_node(i, "has no axis, or children that do not stand behind it.")};
        }
        for (const int child : {node.first_child, node.first_child + 1}) {
            arrivals[place(child)] +=
                tree.nodes[place(child)].parent == static_cast<int>(i) ? 1 : 0;
        }
    }
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
        if (arrivals[i] != 1) {
            faults.push_back(at_node(i, "is not the child of one parent that it names."));
        }
    }
    return faults;
}

KdFaults faults_of_boxes(const KdTree& tree) {
    KdFaults faults;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode& node = tree.nodes[i];
        if (is_leaf(node)) {
            continue;
        }
        const Box& box = tree.boxes[i];
        Box lower = box;
        Box upper = box;
        lower.upper[node.axis] = node.split;
        upper.lower[node.axis] = node.split;
        const Box& first = tree.boxes[place(node.first_child)];
        const Box& second = tree.boxes[place(node.first_child) + 1];
        if (first.lower != lower.lower || first.upper != lower.upper ||
            second.lower != upper.lower || second.upper != upper.upper) {
            faults.push_back(at_node(i, "has children whose boxes are not its own, split."));
        }
        const double least = least_width_in_paddings * tree.padding;
        const double split = node.split;
        if (split - static_cast<double>(box.lower[node.axis]) < least ||
            static_cast<double>(box.upper[node.axis]) - split < least) {
            faults.push_back(at_node(i, "is split too near to a side of its box."));
        }
    }
    return faults;
}

KdFaults faults_of_references(const KdTree& tree, std::size_t triangles) {
    KdFaults faults;
    std::vector<char> taken(tree.references.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode& node = tree.nodes[i];
        if (node.first_reference < 0 || node.end_reference < node.first_reference ||
            place(node.end_reference) > taken.size()) {
            faults.push_back(at_node(i, "has references outside the list."));
            continue;
        }
        if (!is_leaf(node) && node.first_reference != node.end_reference) {
            faults.push_back(at_node(i, "has references, and is no leaf."));
        }
        int last = -1;
        for (int r = node.first_reference; r < node.end_reference; ++r) {
            const int triangle = tree.references[place(r)];
            if (taken[place(r)] != 0 || triangle <= last || place(triangle) >= triangles) {
                faults.push_back(at_node(i, "shares references, or lists them out of order."));
                break;
            }
            taken[place(r)] = 1;
            last = triangle;
        }
    }
    for (const char one : taken) {
        if (one == 0) {
            faults.emplace_back("A reference belongs to no leaf.");
            break;
        }
    }
    return faults;
}

} // namespace raysteps
