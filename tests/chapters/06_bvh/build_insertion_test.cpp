#include "build_trees.h"
#include "catch.h"
#include "scene/shapes.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>

using namespace raysteps;

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

TEST_CASE("an insertion looks no deeper than the depth limit", "[06][build]") {
    // The last cube is nearest to the first one, but above depth 1 there are only pairs.
    const std::vector<BvhItem> items{cube_at(0, 0, 0, 0), cube_at(10, 0, 0, 1),
                                     cube_at(20, 0, 0, 2), cube_at(0.5f, 0, 0, 3)};
    BvhOptions options;
    options.insertion_order = InsertionOrder::as_given;
    const auto sibling_of_last = [&](int depth_limit) {
        options.depth_limit = depth_limit;
        const InsertionTree tree = insert_all(items, options);
        const auto last = std::find_if(tree.nodes.begin(), tree.nodes.end(),
                                       [](const InsertionNode& node) { return node.item == 3; });
        const InsertionNode& parent = tree.nodes[static_cast<std::size_t>(last->parent)];
        return tree.nodes[static_cast<std::size_t>(parent.first_child)].count;
    };
    CHECK(sibling_of_last(64) == 1);
    CHECK(sibling_of_last(0) == 3);
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
