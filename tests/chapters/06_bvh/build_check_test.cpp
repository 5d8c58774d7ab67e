#include "build_trees.h"
#include "catch.h"

#include <algorithm>

using namespace raysteps;

namespace {

const std::vector<glm::vec3>& corners() {
    static const std::vector<glm::vec3> each = random_corners(9, 100);
    return each;
}

// What the check says of a good tree that was broken.
template <class Break>
std::string fault_after(const Break& broken) {
    Bvh bvh = build_bvh(corners(), {});
    broken(bvh);
    return first_fault(bvh, corners());
}

BvhNode& some_leaf(Bvh& bvh) {
    return *std::find_if(bvh.nodes.begin(), bvh.nodes.end(),
                         [](const BvhNode& node) { return node.count > 1; });
}

} // namespace

TEST_CASE("good trees have no faults", "[06][check]") {
    for (const BvhSplit split : all_splits) {
        CHECK(first_fault(build_bvh(corners(), with_split(split)), corners()).empty());
    }
}

TEST_CASE("every kind of broken hierarchy is told", "[06][check]") {
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.order.pop_back(); }), contains_text("a root unless"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.nodes.clear(); }), contains_text("a root unless"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.padding *= 0.5; }), contains_text("less than rays"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.nodes[0].first = 0; }), contains_text("behind it"));
    CHECK_THAT(
        fault_after([](Bvh& bvh) { bvh.nodes[0].first = static_cast<int>(bvh.nodes.size()) - 1; }),
        contains_text("behind it"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.nodes[0].count = -1; }), contains_text("behind it"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.nodes[0].first = 3; }),
               contains_text("is reached from no other"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.nodes.push_back(bvh.nodes.back()); }),
               contains_text("is reached from no other"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.leaf_triangles = 1; }), contains_text("more than 1"));
    CHECK_THAT(fault_after([](Bvh& bvh) { some_leaf(bvh).first = 99; }),
               contains_text("of the list"));
    CHECK_THAT(fault_after([](Bvh& bvh) { some_leaf(bvh).first = -1; }),
               contains_text("of the list"));
    CHECK_THAT(fault_after([](Bvh& bvh) { --some_leaf(bvh).count; }),
               contains_text("is in no leaf"));
    CHECK_THAT(fault_after([](Bvh& bvh) {
                   const auto first = static_cast<std::size_t>(some_leaf(bvh).first);
                   std::swap(bvh.order[first], bvh.order[first + 1]);
               }),
               contains_text("out of order"));
    CHECK_THAT(fault_after([](Bvh& bvh) { bvh.order[7] = 100; }),
               contains_text("and the scene has 100"));
    CHECK_THAT(fault_after([](Bvh& bvh) {
                   const auto child = static_cast<std::size_t>(bvh.nodes[0].first);
                   bvh.nodes[child].box.upper.x = 1e3f;
               }),
               contains_text("does not hold its child"));
    CHECK_THAT(fault_after([](Bvh& bvh) { some_leaf(bvh).box.lower.z = std::nanf(""); }),
               contains_text("nan"));
    CHECK_THAT(fault_after([](Bvh& bvh) {
                   // A box without the padding.
                   BvhNode& leaf = some_leaf(bvh);
                   const auto shrink = static_cast<float>(bvh.padding);
                   leaf.box = {leaf.box.lower + shrink, leaf.box.upper - shrink};
               }),
               contains_text("does not hold triangle"));
}

TEST_CASE("a triangle that two leaves share is told", "[06][check]") {
    const std::vector<glm::vec3> three(corners().begin(), corners().begin() + 9);
    BvhOptions options;
    options.leaf_triangles = 2;
    Bvh bvh = build_bvh(three, options);
    const Box box = bvh.nodes[0].box;
    bvh.nodes = {{box, 1, 0}, {box, 0, 2}, {box, 2, 1}};
    bvh.order = {0, 1, 2};
    REQUIRE(first_fault(bvh, three).empty());
    bvh.nodes[2] = {box, 1, 2};
    CHECK(first_fault(bvh, three) == "Triangle 1 is listed 2 times.");
}
