#include "structure/kd_ropes.h"

namespace raysteps {

namespace {

// From the node down to the smallest one that has the whole face of the box: the one beside the
// face where the split is parallel to it, the one on the face's side where it is not.
int moved_down(const KdTree& tree, int node, const Box& box, int face) {
    const int face_axis = face / 2;
    const int beside = face % 2 == 0 ? 1 : 0; // behind a lower face, the upper child is near
    while (node != no_kd_node) {
        const KdNode& each = tree.nodes[static_cast<std::size_t>(node)];
        if (is_leaf(each)) {
            return node;
        }
        if (each.axis == face_axis) {
            node = each.first_child + beside;
        } else if (box.upper[each.axis] <= each.split) {
            node = each.first_child;
        } else if (box.lower[each.axis] >= each.split) {
            node = each.first_child + 1;
        } else {
            return node;
        }
    }
    return node;
}

} // namespace

KdTree with_ropes(KdTree tree) {
    KdRopes none{};
    none.fill(no_kd_node);
    std::vector<KdRopes> ropes(tree.nodes.size(), none);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        for (int face = 0; face < 6; ++face) {
            int& rope = ropes[i][static_cast<std::size_t>(face)];
            rope = moved_down(tree, rope, tree.boxes[i], face);
        }
        KdNode& node = tree.nodes[i];
        if (is_leaf(node)) {
            node.leaf = static_cast<int>(tree.ropes.size());
            tree.ropes.push_back(ropes[i]);
            continue;
        }
        const auto child = static_cast<std::size_t>(node.first_child);
        const auto axis = static_cast<std::size_t>(node.axis);
        ropes[child] = ropes[i];
        ropes[child + 1] = ropes[i];
        ropes[child][2 * axis + 1] = node.first_child + 1;
        ropes[child + 1][2 * axis] = node.first_child;
    }
    return tree;
}

} // namespace raysteps
