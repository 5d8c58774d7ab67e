#include "structure/bvh/find_faults.h"

#include "structure/padding.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raysteps {

namespace {

// Where the inner box reaches out of the outer one; nothing where it does not. Both are numbers.
struct Excess {
    int axis = 0;
    float side = 0.0f;  // of the outer box
    float reach = 0.0f; // of the inner one
};

std::optional<Excess> excess_of(const Box& outer, const Box& inner) {
    std::optional<Excess> worst;
    const auto take = [&](int axis, float side, float reach) {
        const auto beyond = [](const Excess& excess) {
            return std::abs(static_cast<double>(excess.reach) - static_cast<double>(excess.side));
        };
        const Excess excess{axis, side, reach};
        if (!worst || beyond(excess) > beyond(*worst)) {
            worst = excess;
        }
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (inner.lower[axis] < outer.lower[axis]) {
            take(axis, outer.lower[axis], inner.lower[axis]);
        }
        if (inner.upper[axis] > outer.upper[axis]) {
            take(axis, outer.upper[axis], inner.upper[axis]);
        }
    }
    return worst;
}

// A fault of links has others as its consequence.
std::size_t weight_of(const FaultKind& kind) {
    static const std::array of_links{fault_of_link, fault_of_cycle, fault_of_second_parent,
                                     fault_of_lost_node};
    return static_cast<std::size_t>(std::ranges::find(of_links, kind.name) - of_links.begin());
}

std::string sentence_of(std::size_t node, const std::string& other, const Excess& excess) {
    const double beyond =
        std::abs(static_cast<double>(excess.reach) - static_cast<double>(excess.side));
    return fmt::format("The box of node {} does not hold {}: it ends at {} = {:.9g}, which {} "
                       "reaches {:.9g}, {:.3g} beyond.",
                       node, other, "xyz"[excess.axis], excess.side, other, excess.reach, beyond);
}

bool has_area(std::span<const glm::vec3> corners, std::size_t triangle) {
    const glm::dvec3 a(corners[3 * triangle]);
    const glm::dvec3 b(corners[3 * triangle + 1]);
    const glm::dvec3 c(corners[3 * triangle + 2]);
    return glm::cross(b - a, c - a) != glm::dvec3(0.0);
}

// A node, and the next of its children to go to.
struct Station {
    std::size_t node = 0;
    std::size_t next = 0;
};

// Where each node was met on the way through the tree.
enum class Meeting : std::uint8_t { never, open, closed };

class TreeInspection {
public:
    TreeInspection(const BoxTree& tree, std::span<const glm::vec3> corners, double padding)
        : tree_(tree), corners_(corners), padding_(padding), listed_(corners.size() / 3, 0) {}

    TreeFindings inspect() {
        if (!tree_.nodes.empty()) {
            walk();
            find_lost_nodes();
        }
        find_lost_triangles();
        if (tree_.splits) {
            find_uncovered_points();
        }
        std::ranges::stable_sort(findings_.faults.kinds, {}, weight_of);
        return std::move(findings_);
    }

private:
    void walk() {
        meetings_.assign(tree_.nodes.size(), Meeting::never);
        std::vector<Station> way;
        enter(0, way);
        const auto width = static_cast<std::size_t>(tree_.width);
        while (!way.empty()) {
            Station& here = way.back();
            if (here.next == width) {
                meetings_[here.node] = Meeting::closed;
                way.pop_back();
                continue;
            }
            const std::size_t parent = here.node;
            const std::int32_t child = children_of(tree_, parent)[here.next++];
            if (child != no_child) {
                follow(parent, child, way);
            }
        }
    }

    void follow(std::size_t parent, std::int32_t child, std::vector<Station>& way) {
        if (child < 0 || place_of(child) >= tree_.nodes.size()) {
            findings_.faults.add(fault_of_link, [&] {
                return "Node " + std::to_string(parent) + " has a child " +
                       (child == far_out ? "of a number too large" : std::to_string(child)) +
                       ", and the nodes are 0 to " + std::to_string(tree_.nodes.size() - 1) + ".";
            });
            return;
        }
        const std::size_t node = place_of(child);
        if (meetings_[node] == Meeting::open) {
            findings_.faults.add(fault_of_cycle, [&] {
                return "Node " + std::to_string(parent) + " leads back to node " +
                       std::to_string(node) + ", from which it is reached.";
            });
            return;
        }
        if (meetings_[node] == Meeting::closed) {
            findings_.faults.add(fault_of_second_parent, [&] {
                return "Node " + std::to_string(node) + " is reached twice, the second time from " +
                       "node " + std::to_string(parent) + ".";
            });
            return;
        }
        const Box& own = tree_.nodes[node].box;
        const Box& outer = tree_.nodes[parent].box;
        if (const auto excess = excess_of(outer, own);
            excess && is_finite(own) && is_finite(outer)) {
            findings_.faults.add(fault_of_child_box, [&] {
                return sentence_of(parent, "its child " + std::to_string(node), *excess);
            });
        }
        enter(node, way);
    }

    void enter(std::size_t node, std::vector<Station>& way) {
        const Box& box = tree_.nodes[node].box;
        if (!is_finite(box)) {
            findings_.faults.add(fault_of_numbers, [&] {
                return fmt::format("The box of node {} is ({:g}, {:g}, {:g}) to ({:g}, {:g}, "
                                   "{:g}).",
                                   node, box.lower.x, box.lower.y, box.lower.z, box.upper.x,
                                   box.upper.y, box.upper.z);
            });
        } else if (is_empty(box)) {
            findings_.faults.add(fault_of_sides, [&] {
                return "The box of node " + std::to_string(node) +
                       " has a lower side above its upper one.";
            });
        }
        if (is_leaf(tree_, node)) {
            meetings_[node] = Meeting::closed;
            look_into_leaf(node);
            return;
        }
        meetings_[node] = Meeting::open;
        way.push_back({node, 0});
    }

    void look_into_leaf(std::size_t node) {
        const BvhNode& leaf = tree_.nodes[node];
        if (leaf.count == 0) {
            findings_.faults.add(fault_of_empty_leaf, [&] {
                return "Leaf " + std::to_string(node) + " has no triangle.";
            });
            return;
        }
        if (leaf.first < 0 || leaf.count < 0 ||
            place_of(leaf.first) + place_of(leaf.count) > tree_.order.size()) {
            findings_.faults.add(fault_of_range, [&] {
                return fmt::format("Leaf {} has the triangles {} to {} of the list, and the list "
                                   "has {}.",
                                   node, leaf.first, std::int64_t{leaf.first} + leaf.count - 1,
                                   tree_.order.size());
            });
            return;
        }
        // Leaves that share their triangles again and again would take for ever.
        seen_ += place_of(leaf.count);
        if (seen_ > most_references(tree_)) {
            findings_.faults.add(fault_of_range, [&] {
                return "Leaf " + std::to_string(node) +
                       " has triangles that others have had several times; it is passed over.";
            });
            return;
        }
        for (const std::int32_t triangle :
             std::span(tree_.order).subspan(place_of(leaf.first), place_of(leaf.count))) {
            look_at_triangle(node, triangle);
        }
    }

    void look_at_triangle(std::size_t node, std::int32_t triangle) {
        if (triangle < 0 || place_of(triangle) >= listed_.size()) {
            findings_.faults.add(fault_of_triangle, [&] {
                return triangle == far_out ? "Leaf " + std::to_string(node) +
                                                 " names a triangle that is not in the scene."
                                           : "Leaf " + std::to_string(node) + " names triangle " +
                                                 std::to_string(triangle) + ", and the scene has " +
                                                 std::to_string(listed_.size()) + ".";
            });
            return;
        }
        ++listed_[place_of(triangle)];
        if (tree_.splits) {
            leaves_.emplace_back(triangle, static_cast<std::int32_t>(node));
            return;
        }
        const Box& box = tree_.nodes[node].box;
        const Box own = bounds_of(corners_.subspan(3 * place_of(triangle), 3));
        if (!is_finite(box)) {
            return;
        }
        if (const auto excess = excess_of(box, own)) {
            findings_.faults.add(fault_of_leaf_box, [&] {
                return sentence_of(node, "triangle " + std::to_string(triangle), *excess);
            });
        } else if (const auto room = excess_of(box, pad(own, padding_))) {
            findings_.remarks.add(remark_of_tight_box, [&] {
                return fmt::format("The box of node {} does not hold triangle {} grown by the "
                                   "padding {:.3g}.",
                                   node, triangle, padding_);
            });
        }
    }

    void find_lost_nodes() {
        for (std::size_t i = 0; i < meetings_.size(); ++i) {
            if (meetings_[i] == Meeting::never &&
                !std::ranges::count(tree_.gaps, static_cast<std::int32_t>(i))) {
                findings_.faults.add(fault_of_lost_node, [&] {
                    return "Node " + std::to_string(i) + " is reached from no other.";
                });
            }
        }
    }

    void find_lost_triangles() {
        for (std::size_t i = 0; i < listed_.size(); ++i) {
            if (listed_[i] == 0) {
                const bool area = has_area(corners_, i);
                (area ? findings_.faults : findings_.remarks)
                    .add(area ? fault_of_lost_triangle : remark_of_no_area,
                         [&] { return "Triangle " + std::to_string(i) + " is in no leaf."; });
            } else if (listed_[i] > 1 && !tree_.splits) {
                findings_.faults.add(fault_of_double, [&] {
                    return "Triangle " + std::to_string(i) + " is listed " +
                           std::to_string(listed_[i]) + " times.";
                });
            }
        }
    }

    // Points all over each triangle, each of which lies in the box of a leaf that lists it.
    void find_uncovered_points() {
        constexpr int steps = 6;
        std::sort(leaves_.begin(), leaves_.end());
        for (auto first = leaves_.begin(); first != leaves_.end();) {
            const std::int32_t triangle = first->first;
            const auto end = std::find_if(first, leaves_.end(),
                                          [&](const auto& each) { return each.first != triangle; });
            const glm::dvec3 a(corners_[3 * place_of(triangle)]);
            const glm::dvec3 b(corners_[3 * place_of(triangle) + 1]);
            const glm::dvec3 c(corners_[3 * place_of(triangle) + 2]);
            bool covered = true;
            for (int i = 0; i <= steps && covered; ++i) {
                for (int j = 0; i + j <= steps && covered; ++j) {
                    const glm::dvec3 point =
                        a + (b - a) * (i / double{steps}) + (c - a) * (j / double{steps});
                    covered = std::any_of(first, end, [&](const auto& each) {
                        return holds(tree_.nodes[place_of(each.second)].box, point);
                    });
                }
            }
            if (!covered) {
                findings_.faults.add(fault_of_leaf_box, [&] {
                    return "The boxes of the " + std::to_string(end - first) +
                           " leaves that list triangle " + std::to_string(triangle) +
                           " do not cover it, the first being node " +
                           std::to_string(first->second) + ".";
                });
            }
            first = end;
        }
    }

    // A point that is rounded, in a box whose sides are; NaN holds nothing.
    static bool holds(const Box& box, const glm::dvec3& point) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double room = 0x1p-22 * std::abs(point[axis]);
            inside = inside && static_cast<double>(box.lower[axis]) - room <= point[axis] &&
                     point[axis] <= static_cast<double>(box.upper[axis]) + room;
        }
        return inside;
    }

    const BoxTree& tree_;
    std::span<const glm::vec3> corners_;
    double padding_;
    std::size_t seen_ = 0;             // places of the list, in all leaves so far
    std::vector<std::int32_t> listed_; // how often each triangle is
    std::vector<Meeting> meetings_;
    std::vector<std::pair<std::int32_t, std::int32_t>> leaves_; // triangle and leaf; of splits
    TreeFindings findings_;
};

} // namespace

TreeFindings find_faults(const BoxTree& tree, std::span<const glm::vec3> corners, double padding) {
    return TreeInspection(tree, corners, padding).inspect();
}

} // namespace raysteps
