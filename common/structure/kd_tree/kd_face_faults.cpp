#include "structure/kd_faults.h"

namespace raysteps {

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

} // namespace raysteps
