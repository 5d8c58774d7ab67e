#include "structure/bvh/box_tree.h"

#include "basics/error.h"

#include <algorithm>
#include <string>

namespace raysteps {

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

} // namespace raysteps
