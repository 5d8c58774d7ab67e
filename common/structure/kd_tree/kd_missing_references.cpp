#include "structure/clip_triangle.h"
#include "structure/kd_faults.h"

#include <algorithm>

namespace raysteps {

namespace {

// The part of the padding that a ray can need: 25 of 32 (see structure/padding.h).
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

} // namespace raysteps
