#include "structure/kd_pack.h"

#include <bit>
#include <cstdint>

namespace raysteps {

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
    std::vector<std::int32_t>& ropes = structure.integers["kd_ropes"];
    for (const KdRopes& each : tree.ropes) {
        ropes.insert(ropes.end(), each.begin(), each.end());
    }
    structure.integers["kd_references"] = tree.references;
    structure.points["kd_lower"] = glm::vec3(boxes[0]);
    structure.points["kd_upper"] = glm::vec3(boxes[1]);
    return structure;
}

} // namespace raysteps
