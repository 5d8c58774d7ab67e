#include "structure/kd_tree/check_kd_tree.h"

#include "structure/kd_tree/kd_split.h"

#include <algorithm>
#include <cstddef>

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

namespace {

// Does the second box lie behind that face of the first, and cover all of it?
bool covers(const Box& behind, const Box& box, int face) {
    const int axis = face / 2;
    const bool touches = face % 2 == 0 ? behind.upper[axis] == box.lower[axis]
                                       : behind.lower[axis] == box.upper[axis];
    bool covered = touches;
    for (int other = 0; other < 3; ++other) {
        covered = covered && (other == axis || (behind.lower[other] <= box.lower[other] &&
                                                behind.upper[other] >= box.upper[other]));
    }
    return covered;
}

std::string fault_of_rope(const KdTree& tree, const Box& box, int face, int rope) {
    const int axis = face / 2;
    const Box& whole = tree.boxes.front();
    const bool outermost =
        face % 2 == 0 ? box.lower[axis] == whole.lower[axis] : box.upper[axis] == whole.upper[axis];
    if (rope == no_kd_node) {
        return outermost ? "" : "has no rope behind an inner face.";
    }
    if (rope < 0 || static_cast<std::size_t>(rope) >= tree.nodes.size() ||
        !covers(tree.boxes[static_cast<std::size_t>(rope)], box, face)) {
        return "has a rope to a node that does not hold the whole face.";
    }
    const int child = tree.nodes[static_cast<std::size_t>(rope)].first_child;
    if (child != no_kd_node &&
        (covers(tree.boxes[static_cast<std::size_t>(child)], box, face) ||
         covers(tree.boxes[static_cast<std::size_t>(child) + 1], box, face))) {
        return "has a rope that could lead farther down.";
    }
    return "";
}

} // namespace

KdFaults faults_of_ropes(const KdTree& tree) {
    KdFaults faults;
    std::size_t leaves = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode& node = tree.nodes[i];
        if (!is_leaf(node)) {
            continue;
        }
        if (node.leaf != static_cast<int>(leaves) || leaves >= tree.ropes.size()) {
            return {"Leaf " + std::to_string(i) + " is not numbered, or has no ropes."};
        }
        for (int face = 0; face < 6; ++face) {
            const int rope = tree.ropes[leaves][static_cast<std::size_t>(face)];
            const std::string fault = fault_of_rope(tree, tree.boxes[i], face, rope);
            if (!fault.empty()) {
                faults.push_back("Leaf " + std::to_string(i) + " " + fault);
            }
        }
        ++leaves;
    }
    if (leaves != tree.ropes.size()) {
        faults.emplace_back("There are ropes of no leaf.");
    }
    return faults;
}

namespace {

// The part of the padding that a ray can need: 25 e M of 32 e M (see structure/padding.h).
constexpr double part_needed = 25.0 / 32.0;

bool holds(const ExactBox& box, const glm::vec3& corner) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double coordinate = corner[axis];
        inside = inside && box.lower[axis] <= coordinate && coordinate <= box.upper[axis];
    }
    return inside;
}

bool lists(const KdTree& tree, const KdNode& leaf, int triangle) {
    return std::binary_search(tree.references.begin() + leaf.first_reference,
                              tree.references.begin() + leaf.end_reference, triangle);
}

} // namespace

KdFaults missing_references(const KdTree& tree, std::span<const glm::vec3> corners) {
    KdFaults faults;
    const double padding = part_needed * tree.padding;
    const ExactBox whole = grown(tree.boxes.front(), -padding);
    std::vector<int> open;
    for (std::size_t i = 0; i < corners.size() / 3; ++i) {
        const std::array<glm::vec3, 3> triangle{corners[3 * i], corners[3 * i + 1],
                                                corners[3 * i + 2]};
        if (!std::all_of(triangle.begin(), triangle.end(),
                         [&](const glm::vec3& corner) { return holds(whole, corner); })) {
            faults.push_back("Triangle " + std::to_string(i) + " lies outside the root's box.");
        }
        open.push_back(0);
        while (!open.empty()) {
            const auto place = static_cast<std::size_t>(open.back());
            open.pop_back();
            const KdNode& node = tree.nodes[place];
            if (is_empty(clipped_bounds(triangle, grown(tree.boxes[place], padding), 0.0))) {
                continue;
            }
            if (!is_leaf(node)) {
                open.insert(open.end(), {node.first_child, node.first_child + 1});
                continue;
            }
            if (!lists(tree, node, static_cast<int>(i))) {
                faults.push_back("Leaf " + std::to_string(place) + " does not list triangle " +
                                 std::to_string(i) + ", which reaches into it.");
            }
        }
    }
    return faults;
}

namespace {

constexpr std::size_t most_of_a_kind = 10;

} // namespace

std::vector<std::string> check_kd_tree(const KdTree& tree, std::span<const glm::vec3> corners) {
    KdFaults faults = faults_of_links(tree);
    if (faults.empty()) {
        faults = faults_of_references(tree, corners.size() / 3);
    }
    if (faults.empty()) {
        for (const KdFaults& more :
             {faults_of_boxes(tree), faults_of_ropes(tree), missing_references(tree, corners)}) {
            const std::size_t count = std::min(more.size(), most_of_a_kind);
            faults.insert(faults.end(), more.begin(),
                          more.begin() + static_cast<std::ptrdiff_t>(count));
        }
        return faults;
    }
    faults.resize(std::min(faults.size(), most_of_a_kind));
    return faults;
}

} // namespace raysteps
