#include "catch.h"
#include "kd_hits.h"
#include "scene/shapes.h"
#include "structure/kd_tree/check_kd_tree.h"

#include <algorithm>

using namespace raysteps;

namespace {

const Mesh& mesh() {
    static const Mesh each = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3);
    return each;
}

// What the check says of a good tree that was broken.
template <class Break>
std::string fault_after(const Break& broken) {
    const std::vector<std::string> faults =
        check_kd_tree(broken(build_kd_tree(mesh().corners, {})), mesh().corners);
    return faults.empty() ? "" : faults.front();
}

KdNode& some_leaf(KdTree& tree) {
    return *std::find_if(tree.nodes.begin(), tree.nodes.end(), [](const KdNode& node) {
        return is_leaf(node) && node.end_reference - node.first_reference > 1;
    });
}

} // namespace

TEST_CASE("a good tree has no faults", "[05][check]") {
    CHECK(fault_after([](KdTree tree) { return tree; }).empty());
}

TEST_CASE("every kind of broken tree is told", "[05][check]") {
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.nodes[5].parent = 4;
                   return tree;
               }),
               contains_text("parent"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.nodes[0].first_child = 0;
                   return tree;
               }),
               contains_text("behind it"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.boxes[1].upper.x += 0.25f;
                   return tree;
               }),
               contains_text("not its own"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.padding = 0.25;
                   return tree;
               }),
               contains_text("too near"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   --some_leaf(tree).end_reference;
                   return tree;
               }),
               contains_text("belongs to no leaf"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   const KdNode& leaf = some_leaf(tree);
                   std::swap(tree.references[static_cast<std::size_t>(leaf.first_reference)],
                             tree.references[static_cast<std::size_t>(leaf.first_reference) + 1]);
                   return tree;
               }),
               contains_text("out of order"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   // The only reference of some leaf is made another one.
                   const auto leaf = static_cast<std::size_t>(some_leaf(tree).end_reference - 1);
                   tree.references[leaf] = static_cast<int>(mesh().corners.size() / 3) - 1;
                   return tree;
               }),
               contains_text("does not list"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.ropes[3][2] = 0;
                   tree.ropes[3][3] = 0;
                   return tree;
               }),
               contains_text("rope"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.ropes.pop_back();
                   return tree;
               }),
               contains_text("ropes"));
    CHECK_THAT(fault_after([](KdTree tree) {
                   tree.nodes.pop_back();
                   return tree;
               }),
               contains_text("box for each node"));
}

TEST_CASE("a triangle outside the root is told", "[05][check]") {
    std::vector<glm::vec3> corners = mesh().corners;
    const KdTree tree = build_kd_tree(corners, {});
    corners[1].x += 3.0f;
    CHECK_FALSE(check_kd_tree(tree, corners).empty());
}
