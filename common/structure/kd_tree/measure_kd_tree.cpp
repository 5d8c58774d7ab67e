#include "structure/measure_kd_tree.h"

#include "structure/kd_plane.h"

#include <algorithm>

namespace raysteps {

KdMeasures measure_kd_tree(const KdTree& tree, const KdOptions& options) {
    KdMeasures measures;
    measures.nodes = tree.nodes.size();
    measures.references = tree.references.size();
    measures.bytes = bytes_of(tree);
    const double whole = half_area(tree.boxes.front());
    std::vector<int> depths(tree.nodes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode& node = tree.nodes[i];
        if (node.parent != no_kd_node) {
            depths[i] = depths[static_cast<std::size_t>(node.parent)] + 1;
        }
        measures.depth = std::max(measures.depth, depths[i]);
        const auto count = static_cast<std::size_t>(node.end_reference - node.first_reference);
        double cost = options.traversal_cost;
        if (is_leaf(node)) {
            cost = options.intersection_cost * static_cast<double>(count);
            ++measures.leaves;
            measures.empty_leaves += count == 0 ? 1 : 0;
            measures.longest_leaf = std::max(measures.longest_leaf, count);
        }
        if (!tree.references.empty()) {
            measures.cost += cost * half_area(tree.boxes[i]) / whole;
        }
    }
    return measures;
}

} // namespace raysteps
