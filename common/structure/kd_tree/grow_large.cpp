#include "basics/threads.h"
#include "structure/kd_tree/build_kd_tree.h"

#include <algorithm>
#include <array>

namespace raysteps {

namespace {

struct KdLargeGrowth {
    KdTree tree;
    std::vector<KdLargeBud> left_over;
};

// What of the parts lies on each side of the plane.
std::array<std::vector<KdPart>, 2> parted(const KdTriangles& triangles,
                                          const std::vector<KdPart>& parts, const KdPlane& plane,
                                          const std::array<Box, 2>& boxes) {
    const std::array<ExactBox, 2> around{grown(boxes[0], triangles.padding),
                                         grown(boxes[1], triangles.padding)};
    std::array<std::vector<KdPart>, 2> sides;
    sides[0].reserve(plane.lower_count);
    sides[1].reserve(plane.upper_count);
    for (const KdPart& part : parts) {
        if (part.bounds.lower[plane.axis] >= plane.position) {
            sides[1].push_back(part);
        } else if (part.bounds.upper[plane.axis] <= plane.position) {
            sides[0].push_back(part);
        } else {
            for (std::size_t side = 0; side < 2; ++side) {
                const Box bounds = clipped_bounds(triangle_at(triangles, part.triangle),
                                                  around[side], triangles.padding);
                if (!is_empty(bounds)) {
                    sides[side].push_back({bounds, part.triangle});
                }
            }
        }
    }
    return sides;
}

// Splits by bins. Buds of fewer parts, and those where no plane of theirs pays, are left over.
KdLargeGrowth grow_by_bins(const KdPlan& plan, KdLargeBud first, std::size_t fewest) {
    KdLargeGrowth growth;
    KdTree& tree = growth.tree;
    first.node = 0;
    tree.nodes.emplace_back();
    tree.boxes.push_back(first.box);
    std::vector<KdLargeBud> buds;
    buds.push_back(std::move(first));
    while (!buds.empty()) {
        KdLargeBud bud = std::move(buds.back());
        buds.pop_back();
        const std::size_t count = bud.parts.size();
        const bool is_small = count < fewest || bud.depth >= plan.depth_limit;
        const KdPlane plane =
            is_small ? KdPlane{}
                     : binned_plane(bud.parts, bud.box, plan.triangles.padding, plan.options);
        if (!was_found(plane) || !is_good(plane, count, plan.options)) {
            growth.left_over.push_back(std::move(bud));
            continue;
        }
        tree = with_children(std::move(tree), bud.node, bud.box, plane);
        const int child = tree.nodes[static_cast<std::size_t>(bud.node)].first_child;
        const auto place = static_cast<std::size_t>(child);
        const std::array<Box, 2> boxes{tree.boxes[place], tree.boxes[place + 1]};
        std::array<std::vector<KdPart>, 2> sides = parted(plan.triangles, bud.parts, plane, boxes);
        bud.parts = {};
        for (const int second : {1, 0}) {
            const auto side = static_cast<std::size_t>(second);
            buds.push_back({child + second, boxes[side], bud.depth + 1, 0, std::move(sides[side])});
        }
    }
    return growth;
}

// By sorted events, over a copy of the triangles: what lies together is found in the cache.
KdTree grow_small(const KdPlan& plan, KdLargeBud bud) {
    std::sort(bud.parts.begin(), bud.parts.end(),
              [](const KdPart& a, const KdPart& b) { return a.triangle < b.triangle; });
    std::vector<glm::vec3> corners;
    corners.reserve(3 * bud.parts.size());
    for (const KdPart& part : bud.parts) {
        const std::array<glm::vec3, 3> triangle = triangle_at(plan.triangles, part.triangle);
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    const KdPlan own{{corners, plan.triangles.padding}, plan.options, plan.depth_limit, plan.spent};
    KdTree tree = grow(own, {0, bud.box, bud.depth, bud.bad_splits, events_of(bud.parts)}, 0).tree;
    for (int& reference : tree.references) {
        reference = bud.parts[static_cast<std::size_t>(reference)].triangle;
    }
    return tree;
}

KdTree grow_branch(const KdPlan& plan, KdLargeBud bud) {
    KdLargeGrowth growth = grow_by_bins(plan, std::move(bud), plan.options.most_sorted + 1);
    for (KdLargeBud& small : growth.left_over) {
        const int node = small.node;
        growth.tree = graft(std::move(growth.tree), node, grow_small(plan, std::move(small)));
    }
    return std::move(growth.tree);
}

} // namespace

KdTree grow_large(const KdPlan& plan, KdLargeBud bud) {
    const std::size_t fewest =
        std::max(fewest_of_trunk(bud.parts.size()), plan.options.most_sorted + 1);
    KdLargeGrowth trunk = grow_by_bins(plan, std::move(bud), fewest);
    std::vector<KdTree> branches(trunk.left_over.size());
    on_threads(plan.options.threads, branches.size(), [&](std::size_t i) {
        branches[i] = grow_branch(plan, std::move(trunk.left_over[i]));
    });
    KdTree tree = std::move(trunk.tree);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        tree = graft(std::move(tree), trunk.left_over[i].node, branches[i]);
        branches[i] = {};
    }
    return tree;
}

} // namespace raysteps
