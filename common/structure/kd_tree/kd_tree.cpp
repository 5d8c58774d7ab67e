#include "structure/kd_tree/kd_tree.h"

#include "structure/kd_tree/kd_split.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace raysteps {

KdMeasures measure_kd_tree(const KdTree& tree, const KdOptions& options) {
    KdMeasures measures;
    measures.nodes = tree.nodes.size();
    measures.references = tree.references.size();
    measures.bytes = bytes_of(tree);
    const double whole = surface_area(tree.boxes.front());
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
            measures.cost += cost * surface_area(tree.boxes[i]) / whole;
        }
    }
    return measures;
}

namespace {

glm::ivec4 packed(const KdNode& node) {
    if (is_leaf(node)) {
        return {kd_leaf + 4 * node.leaf, node.first_reference, node.end_reference, node.parent};
    }
    return {node.axis, std::bit_cast<std::int32_t>(node.split), node.first_child, node.parent};
}

// Of no triangles: a box that holds nothing, of numbers that every platform has.
constexpr Box nothing{glm::vec3(1.0f), glm::vec3(-1.0f)};

} // namespace

PackedStructure pack(const KdTree& tree) {
    PackedStructure structure;
    std::vector<glm::ivec4>& nodes = structure.integer_vectors["kd_nodes"];
    for (const KdNode& node : tree.nodes) {
        nodes.push_back(packed(node));
    }
    std::vector<glm::vec4>& boxes = structure.vectors["kd_boxes"];
    for (const Box& box : tree.boxes) {
        const Box& sides = is_empty(box) ? nothing : box;
        boxes.emplace_back(sides.lower, 0.0f);
        boxes.emplace_back(sides.upper, 0.0f);
    }
    std::vector<std::int32_t>& ropes = structure.integers["kd_leaf_ropes"];
    for (const KdRopes& each : tree.ropes) {
        ropes.insert(ropes.end(), each.begin(), each.end());
    }
    structure.integers["kd_references"] = tree.references;
    structure.points["kd_lower"] = glm::vec3(boxes[0]);
    structure.points["kd_upper"] = glm::vec3(boxes[1]);
    return structure;
}

} // namespace raysteps
