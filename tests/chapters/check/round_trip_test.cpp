#include "../../../scripts/trees/raysteps_dump.h"
#include "catch.h"
#include "files.h"
#include "scene/ray_file.h"
#include "structure/grid/build_grid.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "support/scratch_folder.h"

#include <array>
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

TEST_CASE("what raysteps_dump.h writes is the tree that a program had", "[check][file]") {
    const BoxTree tree = tight_tree(ball().corners);
    std::vector<BvhNode> nodes = tree.nodes;
    const std::vector<std::uint32_t> numbers(tree.order.begin(), tree.order.end());
    const ScratchFolder folder("dumped_trees");
    const std::string path = (folder / "dumped.rstree").string();
    const float* const corners = &ball().corners[0].x;
    for (const bool inside : {false, true}) {
        REQUIRE(raysteps_dump::tree(path, 2, "pair", nodes.data(), nodes.size(), sizeof(BvhNode),
                                    {{"lower", "float32", 0, 3},
                                     {"upper", "float32", 12, 3},
                                     {"first", "uint32", 24, 1},
                                     {"count", "uint32", 28, 1}},
                                    numbers.data(), numbers.size(), inside ? corners : nullptr,
                                    inside ? numbers.size() : 0, "\"made_by\": \"a test\""));
        const TreeFile file = read_tree_file(path);
        CHECK(file.made_by == "a test");
        const AnyTree again = in_numbers_of(file, ball().corners);
        CHECK(equal_bytes(std::get<BoxTree>(again).nodes, tree.nodes));
        CHECK(std::get<BoxTree>(again).order == tree.order);
        CHECK(std::get<BoxTree>(again).children == tree.children);
    }
    const std::vector<Hit> hits{{0.5f, 0.25f, 0.125f, 7}, {1e30f, 0.0f, 0.0f, -1}};
    const std::array<float, 2> t{0.5f, 1e30f};
    const std::array<float, 2> u{0.25f, 0.0f};
    const std::array<float, 2> v{0.125f, 0.0f};
    const std::array<std::int32_t, 2> triangles{7, -1};
    REQUIRE(raysteps_dump::hits(path, t.data(), u.data(), v.data(), triangles.data(), 2));
    CHECK(equal_bytes(read_hit_file(path), hits));
    const std::vector<Ray> rays{{{1, 2, 3}, {4, 5, 6}, 0.0f, 7.0f}};
    REQUIRE(raysteps_dump::rays(path, &rays[0].origin.x, 1));
    CHECK(equal_bytes(read_ray_file(path), rays));
}

TEST_CASE("a scene without triangles has a tree too", "[check][file]") {
    const TreeFile file = written_and_read(box_tree_of(Bvh{}));
    CHECK(bvh_of(std::get<BoxTree>(file.tree), 0).nodes.empty());
    const TreeFile kd_file = written_and_read(build_kd_tree({}, {}));
    CHECK(std::get<KdTree>(kd_file.tree).nodes.size() == 1);
}
