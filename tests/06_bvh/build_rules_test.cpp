#include "build_trees.h"
#include "catch.h"
#include "mirror/every_triangle.h"
#include "scene/shapes.h"
#include "structure/split_binned.h"
#include "structure/split_sweep.h"
#include "support/error_of.h"
#include "support/mirror_hits.h"
#include "support/ray_families.h"

#include <rapidcheck.h>

#include <algorithm>
#include <limits>

using namespace raysteps;

namespace {

// Boxes at few places and of few sizes, so that centres, sides and costs are often equal.
std::vector<BvhItem> lattice_items(RandomNumbers& numbers, int count, int steps) {
    std::vector<BvhItem> items;
    for (int i = 0; i < count; ++i) {
        BvhItem item;
        item.triangle = i;
        for (int axis = 0; axis < 3; ++axis) {
            item.box.lower[axis] = static_cast<float>(numbers.below(steps));
            item.box.upper[axis] =
                item.box.lower[axis] + static_cast<float>(1 + numbers.below(steps));
        }
        items.push_back(item);
    }
    return items;
}

BvhRange range_of(std::span<const BvhItem> items) {
    BvhRange range{items, {}, {}};
    for (const BvhItem& item : items) {
        range.box = merge(range.box, item.box);
        range.centers = merge(range.centers, doubled_center(item));
    }
    return range;
}

std::vector<BvhItem> in_order(std::vector<BvhItem> items, int axis) {
    std::stable_sort(items.begin(), items.end(), [axis](const BvhItem& a, const BvhItem& b) {
        return doubled_center(a, axis) < doubled_center(b, axis);
    });
    return items;
}

double surface_of(std::span<const BvhItem> items) {
    return surface_area(range_of(items).box);
}

// The cost of a cut by its definition, from the items alone.
double cost_of(const std::vector<BvhItem>& items, const BvhCut& cut, const BvhOptions& options) {
    const std::vector<BvhItem> ordered = in_order(items, cut.axis);
    const std::span all(ordered);
    const std::span lower = all.first(cut.lower_count);
    const std::span upper = all.subspan(cut.lower_count);
    const double weighted = surface_of(lower) * static_cast<double>(lower.size()) +
                            surface_of(upper) * static_cast<double>(upper.size());
    return options.traversal_cost + options.intersection_cost * weighted / surface_of(all);
}

double least_cost(const std::vector<BvhItem>& items, const BvhOptions& options) {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t count = 1; count < items.size(); ++count) {
            least = std::min(least, cost_of(items, {axis, count}, options));
        }
    }
    return least;
}

// Sides of the lattice are small whole numbers, so areas are exact; a cost is rounded four times.
constexpr double rounding = 4e-15;

bool same_tree(const Bvh& a, const Bvh& b) {
    const auto same_node = [](const BvhNode& left, const BvhNode& right) {
        return left.first == right.first && left.count == right.count &&
               left.box.lower == right.box.lower && left.box.upper == right.box.upper;
    };
    return a.order == b.order &&
           std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node);
}

} // namespace

TEST_CASE("no cut is cheaper than that of the sweep", "[06][build][property]") {
    REQUIRE(rc::check([] {
        RandomNumbers numbers(*rc::gen::inRange(0, 1 << 20));
        const auto count = *rc::gen::inRange(2, 30);
        const std::vector<BvhItem> items = lattice_items(numbers, count, *rc::gen::inRange(1, 20));
        const std::optional<BvhCut> cut = split_sweep(range_of(items), {});
        if (!cut) { // all centres are equal
            const Box centers = range_of(items).centers;
            RC_ASSERT(centers.lower == centers.upper);
            return;
        }
        RC_ASSERT(cut->lower_count >= 1 && cut->lower_count < items.size());
        const double cost = cost_of(items, *cut, {});
        RC_ASSERT(std::abs(cut->cost - cost) <= rounding * cost);
        // Along an axis on which all centres are equal the sweep does not look.
        const Box centers = range_of(items).centers;
        const bool looks_everywhere = glm::all(glm::lessThan(centers.lower, centers.upper));
        RC_ASSERT(!looks_everywhere || cost <= least_cost(items, {}) * (1.0 + rounding));
    }));
}

TEST_CASE("a binned cut costs what it says and not less than a swept one",
          "[06][build][property]") {
    REQUIRE(rc::check([] {
        RandomNumbers numbers(*rc::gen::inRange(0, 1 << 20));
        const auto count = *rc::gen::inRange(2, 60);
        const std::vector<BvhItem> items = lattice_items(numbers, count, *rc::gen::inRange(1, 20));
        BvhOptions options;
        options.bins = *rc::gen::inRange(2, 64);
        const std::optional<BvhCut> cut = split_binned(range_of(items), options);
        const std::optional<BvhCut> swept = split_sweep(range_of(items), options);
        RC_ASSERT(cut.has_value() == swept.has_value());
        if (cut) {
            RC_ASSERT(cut->lower_count >= 1 && cut->lower_count < items.size());
            const double cost = cost_of(items, *cut, options);
            RC_ASSERT(std::abs(cut->cost - cost) <= rounding * cost);
            RC_ASSERT(cost >= swept->cost * (1.0 - rounding));
        }
    }));
}

TEST_CASE("random triangles on a lattice make trees without faults", "[06][build][property]") {
    REQUIRE(rc::check([] {
        RandomNumbers numbers(*rc::gen::inRange(0, 1 << 20));
        const auto count = *rc::gen::inRange(0, 80);
        const auto steps = *rc::gen::inRange(1, 6); // few: many equal centres, some flat triangles
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 3 * count; ++i) {
            corners.emplace_back(numbers.below(steps), numbers.below(steps), numbers.below(steps));
        }
        for (const BvhSplit split : all_splits) {
            BvhOptions options = with_split(split);
            options.leaf_triangles = *rc::gen::inRange(1, 6);
            options.depth_limit = *rc::gen::inRange(0, 12);
            options.bins = *rc::gen::inRange(2, 20);
            const Bvh bvh = build_bvh(corners, options);
            RC_ASSERT(first_fault(bvh, corners) == "");
            const int halving = count == 0 ? 0 : levels_of_halving(corners.size() / 3, options);
            RC_ASSERT(measure_bvh(bvh, options).depth <= std::max(options.depth_limit, halving));
        }
    }));
}

TEST_CASE("each hit lies in the boxes of all nodes above its triangle", "[06][build][property]") {
    const int seed = 61;
    CAPTURE(seed);
    using Loop = mirror::EveryTriangleWatertight<float>;
    for (const float offset : {0.0f, 1000.0f}) { // where coordinates are coarse
        RandomNumbers numbers(seed);
        Scene scene;
        scene = add_mesh(scene, sphere(glm::vec3(offset), 1.0f, 4), {});
        for (const RayFamily& family : ray_families(numbers, scene.corners, 500)) {
            const std::vector<Hit> hits = mirror_hits<Loop>(scene, family.rays);
            for (const BvhSplit split : all_splits) {
                const Bvh bvh = build_bvh(scene.corners, with_split(split));
                std::vector<Box> boxes(scene.corners.size() / 3); // of each triangle's leaf
                for (const BvhNode& node : bvh.nodes) {
                    for (int i = node.first; i < node.first + node.count; ++i) {
                        boxes[static_cast<std::size_t>(bvh.order[static_cast<std::size_t>(i)])] =
                            node.box;
                    }
                }
                int hit_count = 0;
                int outside = 0;
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    if (hits[i].triangle < 0) {
                        continue;
                    }
                    ++hit_count;
                    const Box& box = boxes[static_cast<std::size_t>(hits[i].triangle)];
                    const Ray& ray = family.rays[i];
                    for (int axis = 0; axis < 3; ++axis) {
                        const double at = static_cast<double>(ray.origin[axis]) +
                                          static_cast<double>(hits[i].t) *
                                              static_cast<double>(ray.direction[axis]);
                        outside += at >= static_cast<double>(box.lower[axis]) &&
                                           at <= static_cast<double>(box.upper[axis])
                                       ? 0
                                       : 1;
                    }
                }
                CAPTURE(family.name, offset, static_cast<int>(split));
                CHECK(outside == 0);
                CHECK(hit_count > 50);
            }
        }
    }
}

TEST_CASE("a tree is the same for any number of threads", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(6, 30000);
    for (const BvhSplit split : all_splits) {
        BvhOptions options = with_split(split);
        options.threads = 1;
        const Bvh alone = build_bvh(corners, options);
        CHECK(first_fault(alone, corners).empty());
        for (const unsigned threads : {0U, 2U, 5U}) {
            options.threads = threads;
            CAPTURE(static_cast<int>(split), threads);
            CHECK(same_tree(build_bvh(corners, options), alone));
        }
    }
}

TEST_CASE("the heuristic makes cheaper trees than medians and insertion", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(7, 3000);
    std::array<double, 4> costs{};
    for (const BvhSplit split : all_splits) {
        const BvhOptions options = with_split(split);
        costs[static_cast<std::size_t>(split)] =
            measure_bvh(build_bvh(corners, options), options).cost;
    }
    const auto [median, insertion, binned, sweep] = costs;
    CAPTURE(median, insertion, binned, sweep);
    CHECK(binned < 0.9 * median);
    CHECK(binned < 0.9 * insertion);
    CHECK(std::abs(binned - sweep) < 0.05 * sweep);
}

TEST_CASE("the order of the triangles decides the tree that grows by insertion", "[06][build]") {
    const std::vector<glm::vec3> corners = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 16).corners;
    BvhOptions options = with_split(BvhSplit::insertion);
    const Bvh shuffled = build_bvh(corners, options);
    CHECK(same_tree(build_bvh(corners, options), shuffled));
    options.seed = 2;
    CHECK_FALSE(same_tree(build_bvh(corners, options), shuffled));
    options.insertion_order = InsertionOrder::as_given;
    const Bvh as_given = build_bvh(corners, options);
    CHECK(first_fault(as_given, corners).empty());
    const BvhMeasures worse = measure_bvh(as_given, options);
    const BvhMeasures better = measure_bvh(shuffled, options);
    CAPTURE(worse.cost, better.cost, worse.depth, better.depth);
    CHECK(worse.cost > better.cost);
}

TEST_CASE("options and corners that make no sense are named", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(8, 10);
    const auto error_with = [&](auto change) {
        BvhOptions options;
        change(options);
        return error_of([&] { build_bvh(corners, options); });
    };
    CHECK_THAT(error_with([](BvhOptions& options) { options.bins = 1; }), contains_text("--bins"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.bins = 257; }),
               contains_text("--bins"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.leaf_triangles = 0; }),
               contains_text("--leaf-triangles"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.depth_limit = -1; }),
               contains_text("--depth"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.traversal_cost = std::nan(""); }),
               contains_text("--traversal-cost"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.intersection_cost = -1.0; }),
               contains_text("--intersection-cost"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.reach = INFINITY; }),
               contains_text("reach"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.memory_limit = 679; }),
               contains_text("--memory-limit"));
    CHECK(error_with([](BvhOptions& options) { options.memory_limit = 680; }).empty());
    for (const float wrong : {std::nanf(""), INFINITY, 1.1e37f}) {
        std::vector<glm::vec3> broken = corners;
        broken[4].y = wrong;
        CHECK_THAT(error_of([&] { build_bvh(broken, {}); }), contains_text("Triangle 1 "));
    }
}
