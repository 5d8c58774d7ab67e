#include "structure/kd_tree/build_kd_tree.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "structure/kd_tree/kd_split.h"
#include "structure/padding.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace raysteps {

std::vector<Sides> sorted_out(std::vector<Sides> sides, const KdEvents& events,
                              const KdPlane& plane) {
    const std::vector<KdEvent>& along_axis = events[static_cast<std::size_t>(plane.axis)];
    for (const KdEvent& event : along_axis) {
        if (is_start(event)) {
            sides[static_cast<std::size_t>(triangle_of(event))] =
                event.position >= plane.position ? Sides::upper : Sides::both;
        }
    }
    for (const KdEvent& event : along_axis) {
        if (!is_start(event) && event.position <= plane.position) {
            sides[static_cast<std::size_t>(triangle_of(event))] = Sides::lower;
        }
    }
    return sides;
}

KdEvents events_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides) {
    KdEvents rest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const KdEvent& event : events[axis]) {
            if (sides[static_cast<std::size_t>(triangle_of(event))] == side) {
                rest[axis].push_back(event);
            }
        }
    }
    return rest;
}

std::vector<int> triangles_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides) {
    std::vector<int> triangles;
    for (const KdEvent& event : events[0]) {
        const int triangle = triangle_of(event);
        if (is_start(event) && sides[static_cast<std::size_t>(triangle)] == side) {
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

bool is_good(const KdPlane& plane, std::size_t count, const KdOptions& options) {
    if (options.split == KdSplit::median) {
        return plane.lower_count < count || plane.upper_count < count;
    }
    return plane.cost < options.intersection_cost * static_cast<double>(count);
}

namespace {

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
void pay_for_leaf(const KdPlan& plan, std::size_t count) {
    const std::size_t bytes = 2 * 16 + 2 * 32 + 24 + 4 * count;
    const std::size_t most = std::min(plan.options.most_bytes, most_bytes_of_any);
    if ((plan.spent.bytes += bytes) > most) {
        throw InputError("The kd-tree would need more than " + std::to_string(most >> 20) +
                         " MiB. Raise --leaf-triangles, lower --depth, or raise --memory-limit.");
    }
    // A leaf has six ropes, the longest of its arrays but for the references.
    const std::size_t texels = std::max(6 * ++plan.spent.leaves, plan.spent.references += count);
    if (texels > static_cast<std::size_t>(plan.options.most_texels)) {
        throw MachineError(
            "A kd-tree with arrays of " + std::to_string(texels) +
            " texels or more is asked for, but this machine's OpenGL reads at most " +
            std::to_string(plan.options.most_texels) +
            ". Raise --leaf-triangles, lower --depth, or take --structure "
            "bvh_ordered, which lists each triangle once.");
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

} // namespace

KdTree with_children(KdTree tree, int node, const Box& box, const KdPlane& plane) {
    KdNode& parent = tree.nodes[static_cast<std::size_t>(node)];
    parent.axis = plane.axis;
    parent.split = plane.position;
    parent.first_child = static_cast<int>(tree.nodes.size());
    KdNode child;
    child.parent = node;
    tree.nodes.insert(tree.nodes.end(), {child, child});
    Box lower = box;
    Box upper = box;
    lower.upper[plane.axis] = plane.position;
    upper.lower[plane.axis] = plane.position;
    tree.boxes.insert(tree.boxes.end(), {lower, upper});
    return tree;
}

KdGrowth grow(const KdPlan& plan, KdBud first, std::size_t fewest) {
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
        tree = with_children(std::move(tree), bud.node, bud.box, plane);
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

namespace {

// From the node down to the smallest one that has the whole face of the box: the one beside the
// face where the split is parallel to it, the one on the face's side where it is not.
int moved_down(const KdTree& tree, int node, const Box& box, int face) {
    const int face_axis = face / 2;
    const int beside = face % 2 == 0 ? 1 : 0; // behind a lower face, the upper child is near
    while (node != no_kd_node) {
        const KdNode& each = tree.nodes[static_cast<std::size_t>(node)];
        if (is_leaf(each)) {
            return node;
        }
        if (each.axis == face_axis) {
            node = each.first_child + beside;
        } else if (box.upper[each.axis] <= each.split) {
            node = each.first_child;
        } else if (box.lower[each.axis] >= each.split) {
            node = each.first_child + 1;
        } else {
            return node;
        }
    }
    return node;
}

} // namespace

KdTree with_ropes(KdTree tree) {
    KdRopes none{};
    none.fill(no_kd_node);
    std::vector<KdRopes> ropes(tree.nodes.size(), none);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        for (int face = 0; face < 6; ++face) {
            int& rope = ropes[i][static_cast<std::size_t>(face)];
            rope = moved_down(tree, rope, tree.boxes[i], face);
        }
        KdNode& node = tree.nodes[i];
        if (is_leaf(node)) {
            node.leaf = static_cast<int>(tree.ropes.size());
            tree.ropes.push_back(ropes[i]);
            continue;
        }
        const auto child = static_cast<std::size_t>(node.first_child);
        const auto axis = static_cast<std::size_t>(node.axis);
        ropes[child] = ropes[i];
        ropes[child + 1] = ropes[i];
        ropes[child][2 * axis + 1] = node.first_child + 1;
        ropes[child + 1][2 * axis] = node.first_child;
    }
    return tree;
}

namespace {

constexpr float greatest_coordinate = 1.8e18f; // as of every scene
constexpr std::size_t most_triangles = std::size_t{1} << 28;

void check_count(std::span<const glm::vec3> corners) {
    if (corners.size() / 3 > most_triangles) {
        throw InputError("A kd-tree takes at most " + std::to_string(most_triangles) +
                         " triangles, and there are " + std::to_string(corners.size() / 3) +
                         ". Split the scene.");
    }
}

int usual_depth(std::size_t triangles) {
    return triangles < 2 ? 8
                         : static_cast<int>(8.0 + 1.3 * std::log2(static_cast<double>(triangles)));
}

} // namespace

std::size_t fewest_of_trunk(std::size_t triangles) {
    return std::max<std::size_t>(2048, triangles / 32);
}

namespace {

// By sorted events, with branches on threads of their own.
KdTree grow_sorted(const KdPlan& plan, KdBud bud) {
    KdGrowth trunk = grow(plan, std::move(bud), fewest_of_trunk(plan.triangles.corners.size() / 3));
    std::vector<KdTree> branches(trunk.left_over.size());
    on_threads(plan.options.threads, branches.size(), [&](std::size_t i) {
        branches[i] = grow(plan, std::move(trunk.left_over[i]), 0).tree;
    });
    KdTree tree = std::move(trunk.tree);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        tree = graft(std::move(tree), trunk.left_over[i].node, branches[i]);
        branches[i] = {};
    }
    return tree;
}

} // namespace

KdTree build_kd_tree(std::span<const glm::vec3> corners, const KdOptions& options) {
    check_count(corners);
    check_corners(corners, greatest_coordinate);
    const std::size_t triangles = corners.size() / 3;
    const Box bounds = bounds_of(corners);
    const double padding = padding_for(usual_reach(bounds, options.reach));

    KdSpent spent;
    KdPlan plan{{corners, padding}, options, options.depth_limit, spent};
    if (options.depth_limit < 0) {
        plan.depth_limit = usual_depth(triangles);
    }
    const Box box = triangles > 0 ? pad(bounds, padding) : Box{};
    KdTree tree;
    if (options.split == KdSplit::area && triangles > options.binned_above) {
        tree = grow_large(plan, {0, box, 0, 0, parts_in(plan.triangles, box)});
    } else {
        std::vector<int> all(triangles);
        std::iota(all.begin(), all.end(), 0);
        tree = grow_sorted(plan, {0, box, 0, 0, events_in(plan.triangles, all, box)});
    }
    tree = with_ropes(std::move(tree));
    tree.padding = padding;
    return tree;
}

} // namespace raysteps
