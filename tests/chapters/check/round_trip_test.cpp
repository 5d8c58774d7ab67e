#include "catch.h"
#include "files.h"
#include "structure/grid/build_grid.h"
#include "structure/kd_tree/build_kd_tree.h"

#include <cstring>

using namespace raysteps;

namespace {

template <class Element>
bool equal_bytes(const std::vector<Element>& a, const std::vector<Element>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Element)) == 0);
}

template <class Arrays>
bool equal_arrays(const Arrays& a, const Arrays& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.first == y.first && equal_bytes(x.second, y.second);
    });
}

// Every array and number that a walk reads.
bool equal_bits(const PackedStructure& a, const PackedStructure& b) {
    return equal_arrays(a.vectors, b.vectors) &&
           equal_arrays(a.integer_vectors, b.integer_vectors) &&
           equal_arrays(a.integers, b.integers) && a.points == b.points && a.counts == b.counts &&
           a.numbers == b.numbers;
}

} // namespace

TEST_CASE("a hierarchy of boxes comes back from its file with every bit", "[check][file]") {
    for (const BvhSplit split :
         {BvhSplit::median, BvhSplit::insertion, BvhSplit::binned, BvhSplit::sweep}) {
        CAPTURE(static_cast<int>(split));
        BvhOptions options;
        options.split = split;
        const Bvh bvh = build_bvh(ball().corners, options);
        const TreeFile file = written_and_read(box_tree_of(bvh));
        const Bvh again = bvh_of(std::get<BoxTree>(file.tree), ball().corners.size() / 3);
        CHECK(equal_bytes(bvh.nodes, again.nodes));
        CHECK(bvh.order == again.order);
        CHECK(bvh.padding == again.padding);
        CHECK(equal_bits(pack(bvh, ball().corners), pack(again, ball().corners)));
        const Bvh4 wide = collapse(bvh);
        const TreeFile wide_file = written_and_read(box_tree_of(wide));
        const Bvh4 wide_again =
            bvh4_of(std::get<BoxTree>(wide_file.tree), ball().corners.size() / 3);
        CHECK(equal_bytes(wide.children, wide_again.children));
        CHECK(wide.parents == wide_again.parents);
        CHECK(equal_bits(pack(wide, ball().corners), pack(wide_again, ball().corners)));
    }
}

TEST_CASE("a kd-tree and a grid come back from their files with every bit", "[check][file]") {
    const std::span<const glm::vec3> corners = ball().corners;
    for (const KdSplit split : {KdSplit::area, KdSplit::median}) {
        KdOptions options;
        options.split = split;
        const KdTree tree = build_kd_tree(corners, options);
        const AnyTree again = in_numbers_of(written_and_read(tree), corners);
        CHECK(equal_bits(pack(tree), pack(std::get<KdTree>(again))));
        CHECK(tree.padding == std::get<KdTree>(again).padding);
    }
    const Grid grid = build_grid(corners, {});
    const AnyTree again = in_numbers_of(written_and_read(grid), corners);
    CHECK(equal_bits(pack(grid), pack(std::get<Grid>(again))));
}

TEST_CASE("the file of what a file held is the same file", "[check][file]") {
    const std::string bytes =
        tree_file_bytes({"Raysteps", box_tree_of(build_bvh(ball().corners, {}))});
    CHECK(tree_file_bytes(parse_tree_file(bytes, "same.rstree")) == bytes);
}

TEST_CASE("a scene without triangles has a tree too", "[check][file]") {
    const TreeFile file = written_and_read(box_tree_of(Bvh{}));
    CHECK(bvh_of(std::get<BoxTree>(file.tree), 0).nodes.empty());
    const TreeFile kd_file = written_and_read(build_kd_tree({}, {}));
    CHECK(std::get<KdTree>(kd_file.tree).nodes.size() == 1);
}
