#include "structure/bvh/bvh4.h"

#include "basics/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>

namespace raysteps {

namespace {

constexpr std::size_t texels_per_node = 8;
constexpr std::size_t most_bvh4_nodes = std::size_t{1} << 27;
constexpr float farthest = std::numeric_limits<float>::max();

// The nodes of a binary tree that become the children of one: those that stand in for the branch.
struct Opened {
    std::array<std::int32_t, bvh4_width> nodes{};
    std::array<double, bvh4_width> areas{}; // of those that may be opened; else negative
    std::size_t count = 0;
};

void set_node(Opened& opened, std::size_t place, const Bvh& bvh, std::int32_t number) {
    const BvhNode& node = bvh.nodes[static_cast<std::size_t>(number)];
    opened.nodes[place] = number;
    opened.areas[place] = is_leaf(node) ? -1.0 : surface_area(node.box);
}

Opened open(const Bvh& bvh, std::int32_t branch) {
    Opened opened;
    set_node(opened, opened.count++, bvh, branch);
    while (opened.count < bvh4_width) {
        //# exercise 10.4: which child is opened
        const auto* const largest =
            std::max_element(opened.areas.begin(), opened.areas.begin() + opened.count);
        if (*largest < 0.0) { // all are leaves
            break;
        }
        const auto place = static_cast<std::size_t>(largest - opened.areas.begin());
        //# stub: std::size_t place = 0;
        //# stub: while (place < opened.count && opened.areas[place] < 0.0) {
        //# stub:     ++place;
        //# stub: }
        //# stub: if (place == opened.count) {
        //# stub:     break;
        //# stub: }
        //# end
        const std::int32_t first = bvh.nodes[static_cast<std::size_t>(opened.nodes[place])].first;
        set_node(opened, place, bvh, first);
        set_node(opened, opened.count++, bvh, first + 1);
    }
    return opened;
}

// A branch of the binary tree that becomes a node, and the child that leads to it.
struct Bvh4Branch {
    std::int32_t root = 0;
    std::int32_t child = no_bvh4_node;
};

} // namespace

Bvh4 collapse(const Bvh& bvh) {
    Bvh4 wide;
    wide.order = bvh.order;
    wide.padding = bvh.padding;
    wide.leaf_triangles = bvh.leaf_triangles;
    wide.parents.reserve(bvh.nodes.size() / 2 + 1);
    wide.children.reserve(bvh4_width * (bvh.nodes.size() / 2 + 1));
    std::vector<Bvh4Branch> branches;
    if (!bvh.nodes.empty()) {
        branches.push_back({0, no_bvh4_node});
    }
    while (!branches.empty()) { // the last one first: what is near in the tree is so in memory
        const Bvh4Branch branch = branches.back();
        branches.pop_back();
        if (branch.child != no_bvh4_node) {
            wide.children[static_cast<std::size_t>(branch.child)].first =
                static_cast<std::int32_t>(wide.parents.size());
        }
        wide.parents.push_back(branch.child);
        const Opened opened = open(bvh, branch.root);
        const std::size_t first = wide.children.size();
        wide.children.resize(first + bvh4_width, {{}, no_bvh4_node, 0});
        for (std::size_t i = opened.count; i-- > 0;) {
            const BvhNode& child = bvh.nodes[static_cast<std::size_t>(opened.nodes[i])];
            wide.children[first + i] = child;
            if (!is_leaf(child)) {
                branches.push_back({opened.nodes[i], static_cast<std::int32_t>(first + i)});
            }
        }
    }
    return wide;
}

BvhMeasures measure_bvh4(const Bvh4& bvh, const BvhOptions& options) {
    BvhMeasures measures;
    measures.nodes = bvh.parents.size();
    measures.bytes = texels_per_node * sizeof(glm::ivec4) * bvh.parents.size() +
                     sizeof(std::int32_t) * bvh.order.size();
    if (bvh.parents.empty()) {
        return measures;
    }
    Box root;
    for (std::size_t i = 0; i < bvh4_width; ++i) {
        root = merge(root, bvh.children[i].box);
    }
    const double whole = surface_area(root);
    measures.cost = options.traversal_cost;         // of the root, which each such ray meets
    std::vector<int> depths(bvh.parents.size(), 0); // a parent stands before its children
    for (std::size_t i = 0; i < bvh.children.size(); ++i) {
        const BvhNode& child = bvh.children[i];
        const int depth = depths[i / bvh4_width] + 1;
        const double probability = surface_area(child.box) / whole;
        if (is_leaf(child)) {
            measures.cost += options.intersection_cost * probability * child.count;
            measures.depth = std::max(measures.depth, depth);
            measures.longest_leaf =
                std::max(measures.longest_leaf, static_cast<std::size_t>(child.count));
            measures.references += static_cast<std::size_t>(child.count);
            ++measures.leaves;
        } else if (child.first != no_bvh4_node) {
            depths[static_cast<std::size_t>(child.first)] = depth;
            measures.cost += options.traversal_cost * probability;
        }
    }
    return measures;
}

namespace {

// Where a walk goes that takes the child: to the first texel of a node, or to a leaf.
std::int32_t link_of(const BvhNode& child) {
    if (is_leaf(child)) {
        return -2 - child.first;
    }
    return child.first == no_bvh4_node ? -1
                                       : static_cast<std::int32_t>(texels_per_node) * child.first;
}

// From a node up: behind itself among the children of its parent.
std::int32_t way_up(std::int32_t parent) {
    const int node = parent / bvh4_width;
    const int place = parent % bvh4_width;
    return parent == no_bvh4_node ? -1 : static_cast<int>(texels_per_node) * node + 1 + place;
}

} // namespace

PackedStructure pack(const Bvh4& bvh, std::span<const glm::vec3> corners) {
    if (bvh.parents.size() > most_bvh4_nodes) {
        throw InputError("A BVH of " + std::to_string(bvh.parents.size()) +
                         " nodes is too large for its walks, which take " +
                         std::to_string(most_bvh4_nodes) +
                         ". Raise --leaf-triangles, or take a smaller scene.");
    }
    PackedStructure structure;
    std::vector<glm::ivec4>& texels = structure.integer_vectors["bvh4_nodes"];
    texels.resize(texels_per_node * bvh.parents.size(), glm::ivec4(0));
    for (std::size_t i = 0; i < bvh.children.size(); ++i) {
        const BvhNode& child = bvh.children[i];
        const bool none = link_of(child) == -1; // then the box is one that no ray meets
        const auto column = static_cast<glm::ivec4::length_type>(i % bvh4_width);
        glm::ivec4* const node = &texels[texels_per_node * (i / bvh4_width)];
        for (int axis = 0; axis < 3; ++axis) {
            node[2 * axis][column] =
                std::bit_cast<std::int32_t>(none ? +farthest : child.box.lower[axis]);
            node[2 * axis + 1][column] =
                std::bit_cast<std::int32_t>(none ? -farthest : child.box.upper[axis]);
        }
        node[6][column] = link_of(child);
    }
    for (std::size_t i = 0; i < bvh.parents.size(); ++i) {
        texels[texels_per_node * i + 7].x = way_up(bvh.parents[i]);
    }
    structure.integer_vectors["bvh_triangles"] = pack_leaves(bvh.children, bvh.order, corners);
    structure.numbers["bvh_node_count"] = static_cast<int>(bvh.parents.size());
    return structure;
}

} // namespace raysteps
