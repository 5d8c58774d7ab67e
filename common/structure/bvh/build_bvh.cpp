#include "structure/bvh/build_bvh.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "structure/bvh/bvh_split.h"
#include "structure/padding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace raysteps {

namespace {

// The box around items and the one around their doubled centres.
struct Bounds {
    WideBox box = empty_wide_box();
    WideBox centers = empty_wide_box();
};

// A range of the items that is to become a node.
struct Bud {
    std::size_t node = 0;
    std::size_t first = 0;
    std::size_t count = 0;
    int depth = 0;
    Bounds bounds{};
};

struct Growth {
    std::vector<BvhNode> nodes;
    std::vector<Bud> left_over; // too small for this growth
};

std::size_t most_in_leaf(const BvhOptions& options) {
    return static_cast<std::size_t>(options.leaf_triangles);
}

Bounds grown_by(const Bounds& bounds, const BvhItem& item) {
    const WideBox box = wide_box_of(item);
    const FourFloats center = doubled_center(box);
    return {merge(bounds.box, box), merge(bounds.centers, {center, center})};
}

Bounds range_bounds(std::span<const BvhItem> items) {
    Bounds bounds;
    for (const BvhItem& item : items) {
        bounds = grown_by(bounds, item);
    }
    return bounds;
}

// Where the range is cut; nowhere, where it becomes a leaf.
std::optional<BvhCut> cut_of(const BvhRange& range, int depth, BvhRule rule,
                             const BvhOptions& options) {
    const std::size_t count = range.items.size();
    const bool may_be_leaf = count <= most_in_leaf(options);
    const BvhCut middle{longest_axis(range.centers), count / 2};
    if (is_at_depth_limit(count, depth, options)) {
        return may_be_leaf ? std::nullopt : std::optional(middle);
    }
    if (count < 2) {
        return {};
    }
    const std::optional<BvhCut> cut = rule(range, options);
    const double leaf_cost = options.intersection_cost * static_cast<double>(count);
    if (may_be_leaf && (!cut || cut->cost >= leaf_cost)) {
        return {};
    }
    return cut ? cut : middle;
}

// The bounds of both sides, once the items are parted.
using PartedBounds = std::array<Bounds, 2>;

// By one look at each item, which is all that is needed to know the bounds as well.
PartedBounds part_at(std::span<BvhItem> items, int axis, float first_upper_center) {
    const auto is_lower = [=](const BvhItem& item) {
        return doubled_center(item, axis) < first_upper_center;
    };
    PartedBounds bounds;
    std::size_t first = 0;
    std::size_t end = items.size();
    while (true) {
        for (; first < end && is_lower(items[first]); ++first) {
            bounds[0] = grown_by(bounds[0], items[first]);
        }
        for (; first < end && !is_lower(items[end - 1]); --end) {
            bounds[1] = grown_by(bounds[1], items[end - 1]);
        }
        if (first == end) {
            return bounds;
        }
        // Both change sides. They are looked at before: right after they were written, it would
        // take longer.
        --end;
        bounds[0] = grown_by(bounds[0], items[end]);
        bounds[1] = grown_by(bounds[1], items[first]);
        std::swap(items[first], items[end]);
        ++first;
    }
}

PartedBounds part(std::span<BvhItem> items, const BvhCut& cut) {
    if (cut.first_upper_center) {
        return part_at(items, cut.axis, *cut.first_upper_center);
    }
    const auto comes_first = [axis = cut.axis](const BvhItem& a, const BvhItem& b) {
        const float center_a = doubled_center(a, axis);
        const float center_b = doubled_center(b, axis);
        return center_a != center_b ? center_a < center_b : a.triangle < b.triangle;
    };
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(cut.lower_count),
                     items.end(), comes_first);
    return {range_bounds(items.first(cut.lower_count)),
            range_bounds(items.subspan(cut.lower_count))};
}

// Grows until only buds of fewer items than `fewest` are left.
Growth grow(std::span<BvhItem> items, const Bud& root, BvhRule rule, const BvhOptions& options,
            std::size_t fewest) {
    Growth growth;
    growth.nodes.reserve(fewest == 0 ? root.count : 0); // leaves of two and more are usual
    growth.nodes.emplace_back();
    std::vector<Bud> buds{root};
    buds.back().node = 0;
    while (!buds.empty()) {
        const Bud bud = buds.back();
        buds.pop_back();
        if (bud.count < fewest) {
            growth.left_over.push_back(bud);
            continue;
        }
        const std::span<BvhItem> own = items.subspan(bud.first, bud.count);
        const BvhRange range{own, narrow(bud.bounds.box), narrow(bud.bounds.centers)};
        growth.nodes[bud.node].box = range.box;
        const std::optional<BvhCut> cut = cut_of(range, bud.depth, rule, options);
        if (!cut) {
            std::sort(own.begin(), own.end(),
                      [](const BvhItem& a, const BvhItem& b) { return a.triangle < b.triangle; });
            growth.nodes[bud.node].first = static_cast<std::int32_t>(bud.first);
            growth.nodes[bud.node].count = static_cast<std::int32_t>(bud.count);
            continue;
        }
        const PartedBounds parted = part(own, *cut);
        const std::size_t child = growth.nodes.size();
        growth.nodes[bud.node].first = static_cast<std::int32_t>(child);
        growth.nodes.resize(child + 2);
        const std::size_t middle = bud.first + cut->lower_count;
        buds.push_back({child + 1, middle, bud.count - cut->lower_count, bud.depth + 1, parted[1]});
        buds.push_back({child, bud.first, cut->lower_count, bud.depth + 1, parted[0]});
    }
    return growth;
}

// The trunk is grown on one thread, down to branches of so many items.
std::size_t fewest_of_trunk(std::size_t count) {
    return std::max<std::size_t>(4096, count / 32);
}

} // namespace

bool is_at_depth_limit(std::size_t count, int depth, const BvhOptions& options) {
    const std::size_t leaves = (count + most_in_leaf(options) - 1) / most_in_leaf(options);
    const auto levels = static_cast<int>(std::bit_width(leaves - 1)); // log2, rounded up
    return depth + levels >= options.depth_limit;
}

std::vector<BvhNode> graft(std::vector<BvhNode> nodes, std::size_t node,
                           std::span<const BvhNode> branch, std::size_t first) {
    // The branch's root takes the place of the node, and the rest goes to the end.
    const auto moved = static_cast<std::int32_t>(nodes.size()) - 1;
    nodes.insert(nodes.end(), branch.begin() + 1, branch.end());
    nodes[node] = branch.front();
    const auto move = [&](BvhNode& each) {
        each.first += is_leaf(each) ? static_cast<std::int32_t>(first) : moved;
    };
    move(nodes[node]);
    std::for_each(nodes.begin() + moved + 1, nodes.end(), move);
    return nodes;
}

std::vector<BvhNode> grow_bvh(std::span<BvhItem> items, BvhRule rule, const BvhOptions& options,
                              int depth) {
    if (items.empty()) {
        return {};
    }
    Growth trunk = grow(items, {0, 0, items.size(), depth, range_bounds(items)}, rule, options,
                        fewest_of_trunk(items.size()));
    std::vector<std::vector<BvhNode>> branches(trunk.left_over.size());
    on_threads(options.threads, branches.size(), [&](std::size_t i) {
        branches[i] = grow(items, trunk.left_over[i], rule, options, 0).nodes;
    });
    std::size_t count = trunk.nodes.size();
    for (const std::vector<BvhNode>& branch : branches) {
        count += branch.size();
    }
    std::vector<BvhNode> nodes = std::move(trunk.nodes);
    nodes.reserve(count);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        nodes = graft(std::move(nodes), trunk.left_over[i].node, branches[i], 0);
        branches[i] = {};
    }
    return nodes;
}

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

void check_size(std::span<const glm::vec3> corners, const BvhOptions& options) {
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
    check_size(corners, options);
    check_corners(corners, greatest_coordinate);
    const double padding = padding_for(usual_reach(bounds_of(corners), options.reach));
    Bvh bvh = build_by_split(items_of(corners, padding), options);
    bvh.padding = padding;
    bvh.leaf_triangles = options.leaf_triangles;
    return bvh;
}

} // namespace raysteps
