#include "build_trees.h"
#include "catch.h"
#include "structure/bvh/bvh_split.h"

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

} // namespace

TEST_CASE("a split costs a step and the tests of each side by its share", "[06][build]") {
    // Two cubes at each end of a row of five: halves of 2 x 1 x 1 in a box of 5 x 1 x 1.
    const std::vector<BvhItem> items{cube_at(0, 0, 0, 0), cube_at(1, 0, 0, 1), cube_at(3, 0, 0, 2),
                                     cube_at(4, 0, 0, 3)};
    BvhOptions options;
    options.traversal_cost = 2.0;
    options.intersection_cost = 11.0;
    for (const BvhRule rule : {split_binned, split_sweep}) {
        const std::optional<BvhCut> cut = rule(range_of(items), options);
        REQUIRE(cut.has_value());
        CHECK(cut->axis == 0);
        CHECK(cut->lower_count == 2);
        CHECK(cut->cost == Approx(2.0 + 11.0 * (10.0 * 2 + 10.0 * 2) / 22.0));
    }
}

TEST_CASE("of equal costs the sweep cuts nearest to the middle", "[06][build]") {
    // Ten cubes of 8 between two boxes that are one longer: with one of these on each side, every
    // cut has sides of the same surface.
    std::vector<BvhItem> items{{{{-1, 0, 0}, {8, 8, 8}}, 0}, {{{0, 0, 0}, {9, 8, 8}}, 1}};
    for (int i = 2; i < 12; ++i) {
        items.push_back({{{0, 0, 0}, {8, 8, 8}}, i});
    }
    const std::optional<BvhCut> cut = split_sweep(range_of(items), {});
    REQUIRE(cut.has_value());
    CHECK(cut->lower_count == 6);
}

TEST_CASE("rules know no cut where all centres are equal", "[06][build]") {
    std::vector<BvhItem> items(5, cube_at(1, 2, 3, 0));
    items[3].box = {{0, 1, 2}, {3, 4, 5}};
    CHECK_FALSE(split_binned(range_of(items), {}).has_value());
    CHECK_FALSE(split_sweep(range_of(items), {}).has_value());
}

TEST_CASE("the median halves along the axis on which centres spread farthest", "[06][build]") {
    // Along x the boxes reach farther, along y the centres do.
    std::vector<BvhItem> items{cube_at(0, 0, 0, 0), cube_at(0, 5, 0, 1), cube_at(0, 9, 0, 2),
                               cube_at(0, 2, 0, 3)};
    for (BvhItem& item : items) {
        item.box.upper.x = 100.0f;
    }
    const std::optional<BvhCut> cut = split_median(range_of(items), {});
    REQUIRE(cut.has_value());
    CHECK(cut->axis == 1);
    CHECK(cut->lower_count == 2);
}

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
