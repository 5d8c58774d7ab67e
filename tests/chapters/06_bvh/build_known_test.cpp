#include "build_trees.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "structure/padding.h"

#include <algorithm>

using namespace raysteps;

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
