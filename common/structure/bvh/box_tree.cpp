#include "structure/bvh/box_tree.h"

#include "basics/error.h"

#include <algorithm>
#include <array>
#include <string>

namespace raysteps {

namespace {

std::size_t place_of(std::int32_t number) {
    return static_cast<std::size_t>(number);
}

bool is_child(const BoxTree& tree, std::int32_t child) {
    return child >= 0 && place_of(child) < tree.nodes.size();
}

} // namespace

std::span<const std::int32_t> children_of(const BoxTree& tree, std::size_t node) {
    const auto width = static_cast<std::size_t>(tree.width);
    return std::span(tree.children).subspan(width * node, width);
}

bool is_leaf(const BoxTree& tree, std::size_t node) {
    return std::ranges::all_of(children_of(tree, node),
                               [](std::int32_t child) { return child == no_child; });
}

BoxTree box_tree_of(const Bvh& bvh) {
    BoxTree tree;
    tree.nodes = bvh.nodes;
    tree.order = bvh.order;
    tree.padding = bvh.padding;
    tree.children.assign(2 * bvh.nodes.size(), no_child);
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        if (!is_leaf(bvh.nodes[i])) {
            tree.children[2 * i] = bvh.nodes[i].first;
            tree.children[2 * i + 1] = bvh.nodes[i].first + 1;
        }
    }
    return tree;
}

BoxTree box_tree_of(const Bvh4& bvh) {
    BoxTree tree;
    tree.width = bvh4_width;
    tree.order = bvh.order;
    tree.padding = bvh.padding;
    if (bvh.parents.empty()) {
        return tree;
    }
    std::vector<std::int32_t> places(bvh.children.size(), no_child); // of the children, as nodes
    tree.nodes.emplace_back();
    for (std::size_t i = 0; i < bvh.children.size(); ++i) {
        const BvhNode& child = bvh.children[i];
        if (i < bvh4_width) {
            tree.nodes[0].box = merge(tree.nodes[0].box, child.box);
        }
        if (is_leaf(child) || child.first != no_bvh4_node) {
            places[i] = static_cast<std::int32_t>(tree.nodes.size());
            tree.nodes.push_back(is_leaf(child) ? child : BvhNode{child.box, 0, 0});
        }
    }
    tree.children.assign(bvh4_width * tree.nodes.size(), no_child);
    for (std::size_t node = 0; node < bvh.parents.size(); ++node) {
        const std::int32_t parent = bvh.parents[node];
        const std::size_t own = parent == no_bvh4_node ? 0 : place_of(places[place_of(parent)]);
        std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(bvh4_width * node), bvh4_width,
                    tree.children.begin() + static_cast<std::ptrdiff_t>(bvh4_width * own));
    }
    return tree;
}

namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw InputError(what + ". No walk can go through this tree; `./run.sh check` lists all that "
                            "is wrong with it.");
}

void check_leaf(const BoxTree& tree, std::size_t node, std::size_t triangles) {
    const BvhNode& leaf = tree.nodes[node];
    const std::string name = "leaf " + std::to_string(node);
    if (leaf.count <= 0) {
        refuse(name + " has no triangle");
    }
    if (leaf.first < 0 || place_of(leaf.first) + place_of(leaf.count) > tree.order.size()) {
        refuse(name + " has triangles outside the list");
    }
    for (const std::int32_t triangle :
         std::span(tree.order).subspan(place_of(leaf.first), place_of(leaf.count))) {
        if (triangle < 0 || place_of(triangle) >= triangles) {
            refuse(name + " names triangle " + std::to_string(triangle) + ", and the scene has " +
                   std::to_string(triangles));
        }
    }
}

// A walk must end, and find what the leaves list.
void check_walkable(const BoxTree& tree, std::size_t triangles) {
    if (tree.nodes.empty()) {
        if (triangles > 0) {
            refuse("there is no node");
        }
        return;
    }
    std::vector<char> reached(tree.nodes.size(), 0);
    std::vector<std::size_t> open{0};
    std::size_t references = 0;
    reached[0] = 1;
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        if (is_leaf(tree, node)) {
            references += place_of(std::max(0, tree.nodes[node].count));
            if (references > most_references(tree)) {
                refuse("leaves share their triangles again and again");
            }
            check_leaf(tree, node, triangles);
            continue;
        }
        std::size_t count = 0;
        for (const std::int32_t child : children_of(tree, node)) {
            if (child == no_child) {
                continue;
            }
            if (!is_child(tree, child)) {
                refuse("node " + std::to_string(node) + " has a child outside the list of nodes");
            }
            if (reached[place_of(child)] != 0) {
                refuse("node " + std::to_string(child) + " is reached twice");
            }
            reached[place_of(child)] = 1;
            open.push_back(place_of(child));
            ++count;
        }
        if (tree.width == 2 && count != 2) {
            refuse("node " + std::to_string(node) + " has one child");
        }
    }
}

void check_width(const BoxTree& tree, int most, const std::string& remedy) {
    if (tree.width > most) {
        throw InputError("the tree has up to " + std::to_string(tree.width) +
                         " children a node, and these walks take " + std::to_string(most) + ". " +
                         remedy);
    }
}

// Whether the nodes lie as our builders have them: children side by side behind their parent, and
// nothing else; and each reference in one leaf.
bool lies_as_ours(const BoxTree& tree) {
    std::vector<char> taken(tree.order.size(), 0);
    std::size_t reached = 1;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BvhNode& node = tree.nodes[i];
        if (is_leaf(tree, i)) {
            if (node.count <= 0 || node.first < 0 ||
                place_of(node.first) + place_of(node.count) > tree.order.size()) {
                return false;
            }
            for (std::size_t r = place_of(node.first); r < place_of(node.first + node.count); ++r) {
                if (taken[r]++ != 0) {
                    return false;
                }
            }
            continue;
        }
        const auto children = children_of(tree, i);
        if (children[0] <= static_cast<std::int64_t>(i) || children[1] != children[0] + 1) {
            return false;
        }
        reached += 2;
    }
    return reached == tree.nodes.size();
}

// Copies of leaves, whose triangles are listed once more, one leaf behind the other.
class LeafCopies {
public:
    explicit LeafCopies(const BoxTree& tree) : tree_(tree) {}

    BvhNode copy(std::size_t node) {
        BvhNode leaf = tree_.nodes[node];
        const auto own = std::span(tree_.order).subspan(place_of(leaf.first), place_of(leaf.count));
        leaf.first = static_cast<std::int32_t>(order.size());
        order.insert(order.end(), own.begin(), own.end());
        longest = std::max(longest, leaf.count);
        return leaf;
    }

    std::vector<std::int32_t> order;
    int longest = 1;

private:
    const BoxTree& tree_;
};

int longest_leaf_of(std::span<const BvhNode> nodes) {
    int longest = 1;
    for (const BvhNode& node : nodes) {
        longest = std::max(longest, node.count);
    }
    return longest;
}

} // namespace

Bvh bvh_of(const BoxTree& tree, std::size_t triangles) {
    check_width(tree, 2, "Take --structure bvh4.");
    check_walkable(tree, triangles);
    Bvh bvh;
    bvh.padding = tree.padding;
    if (lies_as_ours(tree)) {
        bvh.nodes = tree.nodes;
        bvh.order = tree.order;
        for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
            if (!is_leaf(tree, i)) {
                bvh.nodes[i].first = children_of(tree, i)[0];
                bvh.nodes[i].count = 0;
            }
        }
        bvh.leaf_triangles = longest_leaf_of(bvh.nodes);
        return bvh;
    }
    LeafCopies leaves(tree);
    std::vector<std::size_t> from; // the node of the tree that each node is
    if (!tree.nodes.empty()) {
        from.push_back(0);
    }
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t node = from[i];
        if (is_leaf(tree, node)) {
            bvh.nodes.push_back(leaves.copy(node));
            continue;
        }
        bvh.nodes.push_back({tree.nodes[node].box, static_cast<std::int32_t>(from.size()), 0});
        for (const std::int32_t child : children_of(tree, node)) {
            from.push_back(place_of(child));
        }
    }
    bvh.order = std::move(leaves.order);
    bvh.leaf_triangles = leaves.longest;
    return bvh;
}

namespace {

// A node of the tree with children, and the place of its own box.
struct WideBranch {
    std::size_t node = 0;
    std::int32_t child = no_bvh4_node;
};

} // namespace

Bvh4 bvh4_of(const BoxTree& tree, std::size_t triangles) {
    if (tree.width == 2) {
        return collapse(bvh_of(tree, triangles));
    }
    check_width(tree, bvh4_width, "Such trees are checked and shown.");
    check_walkable(tree, triangles);
    Bvh4 bvh;
    bvh.padding = tree.padding;
    LeafCopies leaves(tree);
    // In the order of collapse, so that what it made comes back with the same numbers.
    std::vector<WideBranch> branches;
    if (!tree.nodes.empty()) {
        branches.push_back({});
    }
    while (!branches.empty()) {
        const WideBranch branch = branches.back();
        branches.pop_back();
        if (branch.child != no_bvh4_node) {
            bvh.children[place_of(branch.child)].first =
                static_cast<std::int32_t>(bvh.parents.size());
        }
        bvh.parents.push_back(branch.child);
        const std::size_t first = bvh.children.size();
        bvh.children.resize(first + bvh4_width, {{}, no_bvh4_node, 0});
        std::vector<std::size_t> own;
        if (is_leaf(tree, branch.node)) { // the root is one
            own.push_back(branch.node);
        } else {
            for (const std::int32_t child : children_of(tree, branch.node)) {
                if (child != no_child) {
                    own.push_back(place_of(child));
                }
            }
        }
        for (std::size_t i = own.size(); i-- > 0;) {
            if (is_leaf(tree, own[i])) {
                bvh.children[first + i] = tree.nodes[own[i]];
            } else {
                bvh.children[first + i] = {tree.nodes[own[i]].box, no_bvh4_node, 0};
                branches.push_back({own[i], static_cast<std::int32_t>(first + i)});
            }
        }
    }
    // Ranges that leaves share, or that lie among unused ones, get places of their own.
    std::vector<char> taken(tree.order.size(), 0);
    bool shared = false;
    for (const BvhNode& child : bvh.children) {
        for (std::int32_t r = child.first; r < child.first + child.count; ++r) {
            shared = shared || taken[place_of(r)]++ != 0;
        }
    }
    bvh.order = tree.order;
    if (shared) {
        bvh.order.clear();
        for (BvhNode& child : bvh.children) {
            if (is_leaf(child)) {
                const auto own =
                    std::span(tree.order).subspan(place_of(child.first), place_of(child.count));
                child.first = static_cast<std::int32_t>(bvh.order.size());
                bvh.order.insert(bvh.order.end(), own.begin(), own.end());
            }
        }
    }
    bvh.leaf_triangles = longest_leaf_of(bvh.children);
    return bvh;
}

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
