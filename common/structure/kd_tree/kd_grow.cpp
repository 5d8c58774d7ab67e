#include "structure/kd_grow.h"

#include "error/error.h"
#include "structure/kd_plane.h"
#include "structure/kd_sides.h"

#include <algorithm>
#include <string>

namespace raysteps {

namespace {

// Does the split pay by itself? By area, where it costs less than a leaf; in the middle, where a
// side is rid of some triangle.
bool is_good(const KdPlane& plane, std::size_t count, const KdOptions& options) {
    if (options.split == KdSplit::median) {
        return plane.lower_count < count || plane.upper_count < count;
    }
    return plane.cost < options.intersection_cost * static_cast<double>(count);
}

// Where the bud is split; nowhere, where it becomes a leaf.
KdPlane plane_of(const KdPlan& plan, const KdBud& bud) {
    const std::size_t count = triangle_count(bud.events);
    const KdOptions& options = plan.options;
    if (count <= static_cast<std::size_t>(options.leaf_triangles) ||
        bud.depth >= plan.depth_limit) {
        return {};
    }
    const double padding = plan.triangles.padding;
    const KdPlane plane = options.split == KdSplit::median
                              ? middle_plane(bud.events, bud.box, padding)
                              : cheapest_plane(bud.events, bud.box, padding, options);
    if (!was_found(plane) || is_good(plane, count, options)) {
        return plane;
    }
    // Of copies of one triangle, the surface-area heuristic would only make more copies.
    const bool copies = plane.lower_count == count && plane.upper_count == count;
    const bool hopeless = copies && options.split == KdSplit::area;
    return bud.bad_splits < options.bad_splits && !hopeless ? plane : KdPlane{};
}

// References are counted with 32 bits.
constexpr std::size_t most_bytes_of_any = std::size_t{8} << 30;

// A leaf is paid for with its own node, box and ropes and with those of an inner node: there is one
// of those less than there are leaves.
void pay_for_leaf(KdPlan& plan, std::size_t count) {
    const std::size_t bytes = 2 * 16 + 2 * 32 + 24 + 4 * count;
    const std::size_t most = std::min(plan.options.most_bytes, most_bytes_of_any);
    if ((plan.bytes += bytes) > most) {
        throw InputError("The kd-tree would need more than " + std::to_string(most >> 20) +
                         " MiB. Raise --leaf-triangles, lower --depth, or raise --memory-limit.");
    }
}

KdTree with_leaf(KdTree tree, const KdBud& bud) {
    KdNode& node = tree.nodes[static_cast<std::size_t>(bud.node)];
    node.first_reference = static_cast<int>(tree.references.size());
    for (const KdEvent& event : bud.events[0]) {
        if (is_start(event)) {
            tree.references.push_back(triangle_of(event));
        }
    }
    std::sort(tree.references.begin() + node.first_reference, tree.references.end());
    node.end_reference = static_cast<int>(tree.references.size());
    return tree;
}

// The tree with two new nodes at its end, the children of the bud's node.
KdTree with_children(KdTree tree, const KdBud& bud, const KdPlane& plane) {
    KdNode& node = tree.nodes[static_cast<std::size_t>(bud.node)];
    node.axis = plane.axis;
    node.split = plane.position;
    node.first_child = static_cast<int>(tree.nodes.size());
    KdNode child;
    child.parent = bud.node;
    tree.nodes.insert(tree.nodes.end(), {child, child});
    Box lower = bud.box;
    Box upper = bud.box;
    lower.upper[plane.axis] = plane.position;
    upper.lower[plane.axis] = plane.position;
    tree.boxes.insert(tree.boxes.end(), {lower, upper});
    return tree;
}

} // namespace

KdGrowth grow(KdPlan& plan, KdBud first, std::size_t fewest) {
    KdGrowth growth;
    KdTree& tree = growth.tree;
    first.node = 0;
    tree.nodes.emplace_back();
    tree.boxes.push_back(first.box);
    std::vector<Sides> sides(plan.triangles.corners.size() / 3);
    std::vector<KdBud> buds;
    buds.push_back(std::move(first));
    while (!buds.empty()) {
        const KdBud bud = std::move(buds.back());
        buds.pop_back();
        const KdPlane plane = plane_of(plan, bud);
        if (!was_found(plane)) {
            pay_for_leaf(plan, triangle_count(bud.events));
            tree = with_leaf(std::move(tree), bud);
            continue;
        }
        tree = with_children(std::move(tree), bud, plane);
        sides = sorted_out(std::move(sides), bud.events, plane);
        const std::vector<int> cut = triangles_on(Sides::both, bud.events, sides);
        const bool good = is_good(plane, triangle_count(bud.events), plan.options);
        const int child = tree.nodes[static_cast<std::size_t>(bud.node)].first_child;
        for (const int second : {1, 0}) {
            const Box& box = tree.boxes[static_cast<std::size_t>(child) + (second == 1 ? 1 : 0)];
            const Sides side = second == 1 ? Sides::upper : Sides::lower;
            KdBud next{child + second, box, bud.depth + 1, good ? 0 : bud.bad_splits + 1,
                       merge_events(events_on(side, bud.events, sides),
                                    events_in(plan.triangles, cut, box))};
            std::vector<KdBud>& list =
                triangle_count(next.events) < fewest ? growth.left_over : buds;
            list.push_back(std::move(next));
        }
    }
    return growth;
}

KdTree graft(KdTree tree, int node, const KdTree& branch) {
    const auto moved = [&](int place) {
        return place == 0 ? node : static_cast<int>(tree.nodes.size()) + place - 1;
    };
    const int reference = static_cast<int>(tree.references.size());
    std::vector<KdNode> nodes = branch.nodes;
    for (KdNode& each : nodes) {
        each.first_reference += reference;
        each.end_reference += reference;
        each.first_child = is_leaf(each) ? no_kd_node : moved(each.first_child);
        each.parent = each.parent == no_kd_node ? tree.nodes[static_cast<std::size_t>(node)].parent
                                                : moved(each.parent);
    }
    tree.nodes[static_cast<std::size_t>(node)] = nodes.front();
    tree.nodes.insert(tree.nodes.end(), nodes.begin() + 1, nodes.end());
    tree.boxes.insert(tree.boxes.end(), branch.boxes.begin() + 1, branch.boxes.end());
    tree.references.insert(tree.references.end(), branch.references.begin(),
                           branch.references.end());
    return tree;
}

} // namespace raysteps
