#include "structure/measure_bvh.h"

#include "structure/bvh_item.h"

#include <algorithm>

namespace raysteps {

BvhMeasures measure_bvh(const Bvh& bvh, const BvhOptions& options) {
    BvhMeasures measures;
    measures.nodes = bvh.nodes.size();
    measures.bytes = bytes_of(bvh);
    if (bvh.nodes.empty()) {
        return measures;
    }
    const double whole = surface_area(bvh.nodes.front().box);
    std::vector<int> depths(bvh.nodes.size(), 0); // a parent stands before its children
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        const double probability = surface_area(node.box) / whole;
        if (!is_leaf(node)) {
            const auto child = static_cast<std::size_t>(node.first);
            depths[child] = depths[child + 1] = depths[i] + 1;
            measures.cost += options.traversal_cost * probability;
            continue;
        }
        measures.cost += options.intersection_cost * probability * node.count;
        measures.depth = std::max(measures.depth, depths[i]);
        measures.longest_leaf =
            std::max(measures.longest_leaf, static_cast<std::size_t>(node.count));
        ++measures.leaves;
    }
    return measures;
}

} // namespace raysteps
