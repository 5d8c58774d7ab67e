#include "structure/bvh/bvh.h"

#include "basics/error.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

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
        measures.references += static_cast<std::size_t>(node.count);
        ++measures.leaves;
    }
    return measures;
}

namespace {

constexpr int octants = 8;
constexpr std::size_t most_nodes = std::size_t{1} << 26;

// How the two children of an inner node lie to each other.
struct Siblings {
    int axis = 0;
    int lower = 0; // the node that comes first for a ray which ascends along the axis
};

// How the nodes of the tree lie in one octant's order.
struct Order {
    std::vector<Siblings> siblings; // of inner nodes
    std::vector<int> branch;        // how many nodes hang on each, itself included
};

glm::dvec3 doubled_center_of(const Box& box) {
    return glm::dvec3(box.lower) + glm::dvec3(box.upper);
}

// The axis along which the centres are farthest apart.
Siblings siblings_of(const Bvh& bvh, const BvhNode& parent) {
    const auto first = static_cast<std::size_t>(parent.first);
    const glm::dvec3 apart =
        doubled_center_of(bvh.nodes[first + 1].box) - doubled_center_of(bvh.nodes[first].box);
    int axis = std::abs(apart.x) >= std::abs(apart.y) ? 0 : 1;
    axis = std::abs(apart[axis]) >= std::abs(apart.z) ? axis : 2;
    return {axis, parent.first + (apart[axis] < 0.0 ? 1 : 0)};
}

// Children stand behind their parents, so one pass from the end sees the children first.
Order order_of(const Bvh& bvh) {
    Order order;
    order.siblings.resize(bvh.nodes.size());
    order.branch.assign(bvh.nodes.size(), 1);
    for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
        const BvhNode& node = bvh.nodes[i];
        if (!is_leaf(node)) {
            const auto first = static_cast<std::size_t>(node.first);
            order.siblings[i] = siblings_of(bvh, node);
            order.branch[i] += order.branch[first] + order.branch[first + 1];
        }
    }
    return order;
}

struct Children {
    int near = 0;
    int far = 0;
};

Children children_of(const BvhNode& node, const Siblings& siblings, int octant) {
    const int upper = 2 * node.first + 1 - siblings.lower;
    const bool descends = (octant >> siblings.axis & 1) != 0;
    return descends ? Children{upper, siblings.lower} : Children{siblings.lower, upper};
}

// Where each node lies among all nodes of the octant; and so parents first.
std::vector<int> places_in(const Bvh& bvh, const Order& order, int octant) {
    std::vector<int> places(bvh.nodes.size());
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        if (!is_leaf(bvh.nodes[i])) {
            const Children children = children_of(bvh.nodes[i], order.siblings[i], octant);
            const auto near = static_cast<std::size_t>(children.near);
            places[near] = places[i] + 1;
            places[static_cast<std::size_t>(children.far)] = places[near] + order.branch[near];
        }
    }
    return places;
}

glm::ivec4 texel_of(const glm::vec3& point, int number) {
    return {std::bit_cast<std::int32_t>(point.x), std::bit_cast<std::int32_t>(point.y),
            std::bit_cast<std::int32_t>(point.z), number};
}

// The box's planes as a ray of the octant comes to them; of the opposite one, those that it leaves
// by.
glm::vec3 first_planes(const Box& box, int octant) {
    glm::vec3 planes;
    for (int axis = 0; axis < 3; ++axis) {
        planes[axis] = (octant >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis];
    }
    return planes;
}

void put_octant(std::vector<glm::ivec4>& texels, const Bvh& bvh, const Order& order, int octant) {
    const std::vector<int> places = places_in(bvh, order, octant);
    const int count = static_cast<int>(bvh.nodes.size());
    const int start = octant * count;
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        const int behind = places[i] + order.branch[i];
        int link = node.first;
        if (!is_leaf(node)) {
            const Children children = children_of(node, order.siblings[i], octant);
            const int second = start + places[static_cast<std::size_t>(children.far)];
            link = -1 - (4 * second + order.siblings[i].axis);
        }
        const auto texel = 2 * static_cast<std::size_t>(start + places[i]);
        texels[texel] =
            texel_of(first_planes(node.box, octant), behind == count ? -1 : start + behind);
        texels[texel + 1] = texel_of(first_planes(node.box, octants - 1 - octant), link);
    }
}

std::vector<std::int32_t> parents_of(const Bvh& bvh, const Order& order) {
    const std::vector<int> places = places_in(bvh, order, 0);
    std::vector<std::int32_t> parents(bvh.nodes.size(), -1);
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        if (!is_leaf(bvh.nodes[i])) {
            const auto first = static_cast<std::size_t>(bvh.nodes[i].first);
            parents[static_cast<std::size_t>(places[first])] = places[i];
            parents[static_cast<std::size_t>(places[first + 1])] = places[i];
        }
    }
    return parents;
}

} // namespace

PackedStructure pack(const Bvh& bvh, std::span<const glm::vec3> corners) {
    if (bvh.nodes.size() > most_nodes) {
        throw InputError("A BVH of " + std::to_string(bvh.nodes.size()) +
                         " nodes is too large for its walks, which take " +
                         std::to_string(most_nodes) +
                         ". Raise --leaf-triangles, or take a smaller scene.");
    }
    const Order order = order_of(bvh);
    PackedStructure structure;
    std::vector<glm::ivec4>& nodes = structure.integer_vectors["bvh_nodes"];
    nodes.resize(2 * octants * bvh.nodes.size());
    for (int octant = 0; octant < octants; ++octant) {
        put_octant(nodes, bvh, order, octant);
    }
    structure.integer_vectors["bvh_triangles"] = pack_leaves(bvh.nodes, bvh.order, corners);
    structure.integers["bvh_parents"] = parents_of(bvh, order);
    structure.numbers["bvh_node_count"] = static_cast<int>(bvh.nodes.size());
    return structure;
}

std::vector<glm::ivec4> pack_leaves(std::span<const BvhNode> nodes,
                                    std::span<const std::int32_t> order,
                                    std::span<const glm::vec3> corners) {
    std::vector<glm::ivec4> texels(3 * order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto first = 3 * static_cast<std::size_t>(order[i]);
        texels[3 * i] = texel_of(corners[first], order[i]);
        texels[3 * i + 1] = texel_of(corners[first + 1], 0);
        texels[3 * i + 2] = texel_of(corners[first + 2], 0);
    }
    for (const BvhNode& node : nodes) {
        if (is_leaf(node)) {
            texels[3 * static_cast<std::size_t>(node.first + node.count - 1) + 1].w = 1;
        }
    }
    return texels;
}

std::size_t bytes_of(const PackedStructure& packed) {
    std::size_t bytes = 0;
    for (const auto& [name, texels] : packed.vectors) {
        bytes += texels.size() * sizeof(glm::vec4);
    }
    for (const auto& [name, texels] : packed.integer_vectors) {
        bytes += texels.size() * sizeof(glm::ivec4);
    }
    for (const auto& [name, texels] : packed.integers) {
        bytes += texels.size() * sizeof(std::int32_t);
    }
    return bytes;
}

} // namespace raysteps
