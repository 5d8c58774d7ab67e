#include "structure/build_kd_tree.h"

#include "error/error.h"
#include "parallel/on_threads.h"
#include "structure/kd_grow.h"
#include "structure/kd_ropes.h"
#include "structure/padding.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace raysteps {

namespace {

constexpr float greatest_coordinate = 1.8e18f; // as of every scene
constexpr std::size_t most_triangles = std::size_t{1} << 28;

void check_corners(std::span<const glm::vec3> corners) {
    if (corners.size() / 3 > most_triangles) {
        throw InputError("A kd-tree takes at most " + std::to_string(most_triangles) +
                         " triangles, and there are " + std::to_string(corners.size() / 3) +
                         ". Split the scene.");
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(corners[i][axis]) <= greatest_coordinate)) { // nor if not a number
                throw InputError("Triangle " + std::to_string(i / 3) +
                                 " has a corner that is not finite or beyond 1.8e18. Mend the "
                                 "model.");
            }
        }
    }
}

int usual_depth(std::size_t triangles) {
    return triangles < 2 ? 8
                         : static_cast<int>(8.0 + 1.3 * std::log2(static_cast<double>(triangles)));
}

// The trunk is grown on one thread, down to branches of so many triangles.
std::size_t fewest_of_trunk(std::size_t triangles) {
    return std::max<std::size_t>(2048, triangles / 32);
}

} // namespace

KdTree build_kd_tree(std::span<const glm::vec3> corners, const KdOptions& options) {
    check_corners(corners);
    const std::size_t triangles = corners.size() / 3;
    const Box bounds = bounds_of(corners);
    const double padding = padding_for(usual_reach(bounds, options.reach));

    KdPlan plan{{corners, padding}, options, options.depth_limit};
    if (options.depth_limit < 0) {
        plan.depth_limit = usual_depth(triangles);
    }
    KdBud bud;
    if (triangles > 0) {
        bud.box = pad(bounds, padding);
        std::vector<int> all(triangles);
        std::iota(all.begin(), all.end(), 0);
        bud.events = events_in(plan.triangles, all, bud.box);
    }
    KdGrowth trunk = grow(plan, std::move(bud), fewest_of_trunk(triangles));
    std::vector<KdTree> branches(trunk.left_over.size());
    on_threads(options.threads, branches.size(), [&](std::size_t i) {
        branches[i] = grow(plan, std::move(trunk.left_over[i]), 0).tree;
    });
    KdTree tree = std::move(trunk.tree);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        tree = graft(std::move(tree), trunk.left_over[i].node, branches[i]);
        branches[i] = {};
    }
    tree = with_ropes(std::move(tree));
    tree.padding = padding;
    return tree;
}

} // namespace raysteps
