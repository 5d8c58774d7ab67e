#include "structure/bvh/box_tree.h"

#include <algorithm>
#include <array>

namespace raysteps {

namespace {

Box common_part(const Box& a, const Box& b) {
    return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

double volume_of(const Box& box) {
    double volume = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        volume *= std::max(0.0, static_cast<double>(box.upper[axis]) -
                                    static_cast<double>(box.lower[axis]));
    }
    return volume;
}

// The volume of what the boxes from `next` on cover of the part, by inclusion and exclusion: terms
// end where nothing is left in common.
double covered_volume(std::span<const Box> boxes, const Box& part) {
    double covered = 0.0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box own = common_part(part, boxes[i]);
        const double volume = volume_of(own);
        if (volume > 0.0) {
            covered += volume - covered_volume(boxes.first(i), own);
        }
    }
    return covered;
}

struct OpenNode {
    std::size_t node = 0;
    int depth = 0;
};

// The sums over inner nodes that become means.
struct InnerSums {
    double surface = 0.0;
    double empty_surface = 0.0;
};

} // namespace

BoxTreeMeasures measure_box_tree(const BoxTree& tree, const BvhOptions& options) {
    BoxTreeMeasures measures;
    if (tree.nodes.empty()) {
        return measures;
    }
    const double whole = surface_area(tree.nodes.front().box);
    InnerSums sums;
    std::vector<char> reached(tree.nodes.size(), 0);
    std::vector<OpenNode> open{{0, 0}};
    reached[0] = 1;
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        const Box& box = tree.nodes[node].box;
        const double surface = surface_area(box);
        const double probability = whole > 0.0 ? surface / whole : 0.0;
        ++measures.tree.nodes;
        if (is_leaf(tree, node)) {
            const auto count = static_cast<std::size_t>(std::clamp<std::int64_t>(
                tree.nodes[node].count, 0, static_cast<std::int64_t>(tree.order.size())));
            measures.tree.cost +=
                options.intersection_cost * probability * static_cast<double>(count);
            measures.tree.depth = std::max(measures.tree.depth, depth);
            measures.tree.longest_leaf = std::max(measures.tree.longest_leaf, count);
            ++measures.tree.leaves;
            measures.tree.references += count;
            ++measures.leaves_of_size[count];
            continue;
        }
        measures.tree.cost += options.traversal_cost * probability;
        std::array<Box, 8> boxes;
        std::size_t count = 0;
        for (const std::int32_t child : children_of(tree, node)) {
            if (!is_child(tree, child) || reached[place_of(child)] != 0) {
                continue;
            }
            reached[place_of(child)] = 1;
            open.push_back({place_of(child), depth + 1});
            boxes[count] = tree.nodes[place_of(child)].box;
            for (std::size_t other = 0; other < count && whole > 0.0; ++other) {
                const Box both = common_part(boxes[count], boxes[other]);
                measures.overlap += surface_area(both) / whole;
            }
            ++count;
        }
        const double volume = volume_of(box);
        if (volume > 0.0) {
            const double covered = covered_volume(std::span(boxes).first(count), box);
            sums.surface += surface;
            sums.empty_surface += surface * std::max(0.0, 1.0 - covered / volume);
        }
    }
    measures.empty_space = sums.surface > 0.0 ? sums.empty_surface / sums.surface : 0.0;
    measures.tree.bytes = sizeof(BvhNode) * tree.nodes.size() +
                          (tree.width > 2 ? sizeof(std::int32_t) * tree.children.size() : 0) +
                          sizeof(std::int32_t) * tree.order.size();
    return measures;
}

} // namespace raysteps
