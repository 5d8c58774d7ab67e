#include "build_trees.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <cmath>

using namespace raysteps;

namespace {

// How often the walk from the root to all leaves comes to each node.
std::vector<int> arrivals(const Bvh& bvh) {
    std::vector<int> arrivals(bvh.nodes.size(), 0);
    std::vector<std::size_t> stack{0};
    while (!stack.empty()) {
        const std::size_t node = stack.back();
        stack.pop_back();
        ++arrivals[node];
        if (!is_leaf(bvh.nodes[node])) {
            const auto child = static_cast<std::size_t>(bvh.nodes[node].first);
            stack.insert(stack.end(), {child, child + 1});
        }
    }
    return arrivals;
}

} // namespace

TEST_CASE("V1 a million equal centres are halved until leaves are small", "[06][hard_case]") {
    const int seed = 71;
    CAPTURE(seed);
    const int count = 1000000;
    for (const bool equal_sizes : {true, false}) {
        const std::vector<glm::vec3> corners =
            equal_sizes ? copies_of_a_triangle(count).corners : concentric_triangles(seed, count);
        for (const BvhSplit split : {BvhSplit::median, BvhSplit::binned, BvhSplit::sweep}) {
            CAPTURE(equal_sizes, static_cast<int>(split));
            const BvhOptions options = with_split(split);
            const Bvh bvh = build_bvh(corners, options);
            const BvhMeasures measures = measure_bvh(bvh, options);
            CHECK(measures.depth == levels_of_halving(count, options));
            CHECK(first_fault(bvh, corners).empty());
        }
    }
}

TEST_CASE("V1 copies do not make a chain of a tree that grows by insertion", "[06][hard_case]") {
    const int seed = 72;
    CAPTURE(seed);
    const int count = 200000;
    const BvhOptions options = with_split(BvhSplit::insertion);
    const std::vector<glm::vec3> copies = copies_of_a_triangle(count).corners;
    const Bvh bvh = build_bvh(copies, options);
    CHECK(first_fault(bvh, copies).empty());
    CHECK(measure_bvh(bvh, options).depth <= levels_of_halving(count, options) + 1);
    const std::vector<glm::vec3> nested = concentric_triangles(seed, count);
    CHECK(measure_bvh(build_bvh(nested, options), options).depth <= options.depth_limit);
}

TEST_CASE("V2 trees of no triangle and of one are valid", "[06][hard_case]") {
    const std::vector<glm::vec3> one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::vec3> point(3, glm::vec3(0.0f));
    for (const BvhSplit split : all_splits) {
        CAPTURE(static_cast<int>(split));
        const Bvh none = build_bvh({}, with_split(split));
        CHECK(none.nodes.empty());
        CHECK(none.order.empty());
        CHECK(first_fault(none, {}).empty());
        CHECK(measure_bvh(none, {}).cost == 0.0);
        for (const std::vector<glm::vec3>& corners : {one, point}) {
            const Bvh bvh = build_bvh(corners, with_split(split));
            CHECK(first_fault(bvh, corners).empty());
            REQUIRE(bvh.nodes.size() == 1);
            CHECK(is_leaf(bvh.nodes[0]));
            CHECK(measure_bvh(bvh, {}).cost == BvhOptions{}.intersection_cost);
        }
    }
}

TEST_CASE("V3 triangles at powers of two make a deep tree unless the depth is limited",
          "[06][hard_case]") {
    const std::vector<glm::vec3> corners = triangles_at_powers_of_two();
    for (const BvhSplit split : all_splits) {
        CAPTURE(static_cast<int>(split));
        BvhOptions options = with_split(split);
        options.leaf_triangles = 1;
        options.depth_limit = 1000;
        const Bvh deep = build_bvh(corners, options);
        CHECK(first_fault(deep, corners).empty());
        const int depth = measure_bvh(deep, options).depth;
        if (split == BvhSplit::sweep) {
            CHECK(depth > 10); // and so deeper than the limits below
        }
        for (const int limit : {0, 7, 10}) {
            options.depth_limit = limit;
            const Bvh flat = build_bvh(corners, options);
            CHECK(first_fault(flat, corners).empty());
            CHECK(measure_bvh(flat, options).depth <= std::max(limit, 7)); // 2^7 > 121
        }
    }
}

TEST_CASE("V3 a chain of a hundred thousand nodes is no recursion", "[06][hard_case]") {
    // Each box holds all before it, so the cheapest place is above all of them.
    const int count = 100000;
    const std::vector<glm::vec3> corners = shells(count);
    BvhOptions options = with_split(BvhSplit::insertion);
    options.insertion_order = InsertionOrder::as_given;
    options.leaf_triangles = 1;
    options.depth_limit = 1 << 20;
    const Bvh chain = build_bvh(corners, options);
    CHECK(first_fault(chain, corners).empty());
    CHECK(measure_bvh(chain, options).depth == count - 1);
    options.depth_limit = 64;
    const Bvh limited = build_bvh(corners, options);
    CHECK(first_fault(limited, corners).empty());
    CHECK(measure_bvh(limited, options).depth <= 64);
}

TEST_CASE("V4 areas that are no floats part two heaps all the same", "[06][hard_case]") {
    CHECK(surface_area({glm::vec3(-1e30f), glm::vec3(1e30f)}) == Approx(24e60));
    const std::vector<glm::vec3> corners = heaps_at_the_end_of_floats(73);
    for (const BvhSplit split : all_splits) {
        CAPTURE(static_cast<int>(split));
        const BvhOptions options = with_split(split);
        const Bvh bvh = build_bvh(corners, options);
        CHECK(first_fault(bvh, corners).empty());
        CHECK(std::max(bvh.nodes[1].box.lower.x, bvh.nodes[2].box.lower.x) > 0.0f);
        CHECK(std::min(bvh.nodes[1].box.upper.x, bvh.nodes[2].box.upper.x) < 0.0f);
        // Leaves of 64 triangles: each is met seldom, and a leaf of all would cost 64 tests.
        CHECK(measure_bvh(bvh, options).cost < 0.5 * 64 * options.intersection_cost);
    }
}

TEST_CASE("V5 every node is reached exactly once", "[06][hard_case]") {
    for (const int triangles : {1, 2, 5, 1000, 20000}) {
        const std::vector<glm::vec3> corners = random_corners(74, triangles);
        for (const BvhSplit split : all_splits) {
            CAPTURE(triangles, static_cast<int>(split));
            const Bvh bvh = build_bvh(corners, with_split(split));
            const std::vector<int> visits = arrivals(bvh);
            CHECK(std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; }));
            CHECK(first_fault(bvh, corners).empty());
        }
    }
}
