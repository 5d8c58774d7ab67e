#include "structure/build_bvh.h"

#include "error/error.h"
#include "structure/bvh_flatten.h"
#include "structure/bvh_grow.h"
#include "structure/bvh_insertion.h"
#include "structure/padding.h"
#include "structure/split_binned.h"
#include "structure/split_median.h"
#include "structure/split_sweep.h"

#include <cmath>
#include <string>

namespace raysteps {

namespace {

// Centres are sums of two coordinates, and boxes are padded: both must stay floats.
constexpr float greatest_coordinate = 1e37f;
constexpr std::size_t most_triangles = std::size_t{1} << 28;
// A tree of one triangle a leaf: two nodes, less one for all, and its place in the order.
constexpr std::size_t most_bytes_a_triangle = 2 * sizeof(BvhNode) + sizeof(std::int32_t);

bool is_cost(double value) {
    return value >= 0.0 && value <= 1e6; // nor if not a number
}

void check_options(const BvhOptions& options) {
    if (options.bins < 2 || options.bins > 256) {
        throw InputError("--bins " + std::to_string(options.bins) +
                         ": a BVH takes 2 to 256 bins along an axis.");
    }
    if (options.leaf_triangles < 1 || options.leaf_triangles > 1 << 20) {
        throw InputError("--leaf-triangles " + std::to_string(options.leaf_triangles) +
                         ": a leaf has room for 1 to 1048576 triangles.");
    }
    if (options.depth_limit < 0 || options.depth_limit > 1 << 20) {
        throw InputError("--depth " + std::to_string(options.depth_limit) +
                         ": a leaf lies 0 to 1048576 levels below the root.");
    }
    if (!is_cost(options.traversal_cost) || !is_cost(options.intersection_cost)) {
        throw InputError("--traversal-cost and --intersection-cost are numbers from 0 to 1000000.");
    }
    if (!(options.reach >= 0.0 && std::isfinite(options.reach))) {
        throw InputError("The reach of the rays must be 0 or more, and finite.");
    }
}

void check_corners(std::span<const glm::vec3> corners, const BvhOptions& options) {
    const std::size_t triangles = corners.size() / 3;
    if (triangles > most_triangles) {
        throw InputError("A BVH takes at most " + std::to_string(most_triangles) +
                         " triangles, and there are " + std::to_string(triangles) +
                         ". Split the scene.");
    }
    if (static_cast<std::int64_t>(triangles * most_bytes_a_triangle) > options.memory_limit) {
        throw InputError("A BVH of " + std::to_string(triangles) + " triangles can take " +
                         std::to_string((triangles * most_bytes_a_triangle >> 20) + 1) +
                         " MiB, and it may take " + std::to_string(options.memory_limit >> 20) +
                         ". Raise --memory-limit, or take a smaller scene.");
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(corners[i][axis]) <= greatest_coordinate)) { // nor if not a number
                throw InputError("Triangle " + std::to_string(i / 3) +
                                 " has a corner that is not finite or beyond 1e37. Mend the "
                                 "model.");
            }
        }
    }
}

std::vector<BvhItem> items_of(std::span<const glm::vec3> corners, double padding) {
    std::vector<BvhItem> items(corners.size() / 3);
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i] = {pad(bounds_of(corners.subspan(3 * i, 3)), padding),
                    static_cast<std::int32_t>(i)};
    }
    return items;
}

Bvh build_from_the_top(std::vector<BvhItem> items, BvhRule rule, const BvhOptions& options) {
    Bvh bvh;
    bvh.nodes = grow_bvh(items, rule, options, 0);
    bvh.order.reserve(items.size());
    for (const BvhItem& item : items) {
        bvh.order.push_back(item.triangle);
    }
    return bvh;
}

Bvh build_by_split(std::vector<BvhItem> items, const BvhOptions& options) {
    switch (options.split) {
    case BvhSplit::median:
        return build_from_the_top(std::move(items), split_median, options);
    case BvhSplit::insertion:
        return flattened(insert_all(items, options), items, options);
    case BvhSplit::sweep:
        return build_from_the_top(std::move(items), split_sweep, options);
    case BvhSplit::binned:
        break;
    }
    return build_from_the_top(std::move(items), split_binned, options);
}

} // namespace

Bvh build_bvh(std::span<const glm::vec3> corners, const BvhOptions& options) {
    check_options(options);
    check_corners(corners, options);
    const double padding = padding_for(usual_reach(bounds_of(corners), options.reach));
    Bvh bvh = build_by_split(items_of(corners, padding), options);
    bvh.padding = padding;
    bvh.leaf_triangles = options.leaf_triangles;
    return bvh;
}

} // namespace raysteps
