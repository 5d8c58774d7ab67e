#include "build_trees.h"
#include "catch.h"
#include "structure/bvh_insertion.h"
#include "structure/padding.h"
#include "structure/split_binned.h"
#include "structure/split_median.h"
#include "structure/split_sweep.h"

#include <algorithm>

using namespace raysteps;

namespace {

// A cube of side 1 whose lower corner is there.
BvhItem cube_at(float x, float y, float z, int triangle) {
    return {{{x, y, z}, {x + 1.0f, y + 1.0f, z + 1.0f}}, triangle};
}

BvhRange range_of(std::span<const BvhItem> items) {
    BvhRange range{items, {}, {}};
    for (const BvhItem& item : items) {
        range.box = merge(range.box, item.box);
        range.centers = merge(range.centers, doubled_center(item));
    }
    return range;
}

} // namespace

TEST_CASE("a surface area is that of six faces and that of an empty box is zero", "[06][build]") {
    CHECK(surface_area({glm::vec3(1.0f), {2.0f, 3.0f, 4.0f}}) == 22.0);
    CHECK(surface_area({glm::vec3(0.0f), {2.0f, 3.0f, 0.0f}}) == 12.0);
    CHECK(surface_area(Box{}) == 0.0);
}

TEST_CASE("the cost of a tree counts nodes by their share of the surface", "[06][build]") {
    // The root has the surface 10, and two cubes of 6 fill it: p = 0.6 for each of them.
    Bvh bvh;
    bvh.nodes = {{{glm::vec3(0.0f), {2.0f, 1.0f, 1.0f}}, 1, 0},
                 {{glm::vec3(0.0f), glm::vec3(1.0f)}, 0, 1},
                 {{{1.0f, 0.0f, 0.0f}, {2.0f, 1.0f, 1.0f}}, 1, 2}};
    bvh.order = {0, 1, 2};
    BvhOptions options;
    options.traversal_cost = 2.0;
    options.intersection_cost = 10.0;
    const BvhMeasures measures = measure_bvh(bvh, options);
    CHECK(measures.cost == Approx(2.0 + 10.0 * (0.6 * 1 + 0.6 * 2)));
    CHECK(measures.nodes == 3);
    CHECK(measures.leaves == 2);
    CHECK(measures.longest_leaf == 2);
    CHECK(measures.depth == 1);
    CHECK(measures.bytes == 3 * 32 + 3 * 4);
}

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

TEST_CASE("trees by medians are as flat as can be", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(3, 1000);
    BvhOptions options = with_split(BvhSplit::median);
    for (const int leaf_triangles : {1, 2, 3, 4, 7, 1000}) {
        options.leaf_triangles = leaf_triangles;
        CAPTURE(leaf_triangles);
        const BvhMeasures measures = measure_bvh(build_bvh(corners, options), options);
        CHECK(measures.depth == levels_of_halving(1000, options));
    }
}

TEST_CASE("two heaps of triangles are parted between them", "[06][build]") {
    // Insertion is told the heaps in turns: it parts them only if it looks at areas.
    std::vector<glm::vec3> corners;
    RandomNumbers numbers(4);
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 heap(i % 2 == 0 ? 0.0f : 9.0f, 0.0f, 0.0f);
        const std::vector<glm::vec3> own = triangle_around(heap + numbers.in_cube(), {1, 1, 1});
        corners.insert(corners.end(), own.begin(), own.end());
    }
    for (const BvhSplit split : all_splits) {
        CAPTURE(static_cast<int>(split));
        const Bvh bvh = build_bvh(corners, with_split(split));
        CHECK(first_fault(bvh, corners).empty());
        const Box a = bvh.nodes[1].box;
        const Box b = bvh.nodes[2].box;
        CHECK(std::min(a.upper.x, b.upper.x) < 3.0f);
        CHECK(std::max(a.lower.x, b.lower.x) > 6.0f);
    }
}

TEST_CASE("an inserted item becomes the sibling of what is nearest to it", "[06][build]") {
    const std::vector<BvhItem> items{cube_at(0, 0, 0, 0), cube_at(10, 0, 0, 1),
                                     cube_at(0.5f, 0, 0, 2), cube_at(10.5f, 0, 0, 3)};
    BvhOptions options;
    options.insertion_order = InsertionOrder::as_given;
    const InsertionTree tree = insert_all(items, options);
    REQUIRE(tree.nodes.size() == 7);
    std::vector<float> uppers;
    for (const InsertionNode& node : tree.nodes) {
        if (!is_leaf(node) && node.count == 2) {
            uppers.push_back(node.box.upper.x);
        }
    }
    std::sort(uppers.begin(), uppers.end());
    CHECK(uppers == std::vector<float>{1.5f, 11.5f});
    CHECK(tree.nodes[static_cast<std::size_t>(tree.root)].count == 4);
}

TEST_CASE("a leaf stays whole where a split costs no less", "[06][build]") {
    // Two triangles in the same place: a step to two leaves is a step more. Two far apart: a ray
    // through the root meets either of them seldom.
    std::vector<glm::vec3> near = triangle_around({0, 0, 0}, {1, 1, 1});
    std::vector<glm::vec3> far = near;
    for (const float x : {0.001f, 100.0f}) {
        const std::vector<glm::vec3> other = triangle_around({x, 0, 0}, {1, 1, 1});
        std::vector<glm::vec3>& corners = x < 1.0f ? near : far;
        corners.insert(corners.end(), other.begin(), other.end());
    }
    for (const BvhSplit split : {BvhSplit::insertion, BvhSplit::binned, BvhSplit::sweep}) {
        CAPTURE(static_cast<int>(split));
        CHECK(build_bvh(near, with_split(split)).nodes.size() == 1);
        CHECK(build_bvh(far, with_split(split)).nodes.size() == 3);
        BvhOptions one_a_leaf = with_split(split);
        one_a_leaf.leaf_triangles = 1;
        CHECK(build_bvh(near, one_a_leaf).nodes.size() == 3);
    }
    // The median knows no cost.
    CHECK(build_bvh(far, with_split(BvhSplit::median)).nodes.size() == 1);
}

TEST_CASE("a box of one triangle is that of its corners grown by the padding", "[06][build]") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {4, 0, 0}, {0, 2, 1}};
    BvhOptions options;
    options.reach = 1000.0;
    for (const BvhSplit split : all_splits) {
        options.split = split;
        const Bvh bvh = build_bvh(corners, options);
        REQUIRE(bvh.nodes.size() == 1);
        CHECK(bvh.padding == padding_for(1000.0));
        const Box padded = pad(bounds_of(corners), bvh.padding);
        CHECK(bvh.nodes[0].box.lower == padded.lower);
        CHECK(bvh.nodes[0].box.upper == padded.upper);
    }
}
