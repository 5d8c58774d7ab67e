#include "structure/bvh/bvh4.h"

#include "build_trees.h"
#include "bvh_hits.h"
#include "catch.h"
#include "scene/shapes.h"
#include "support/error_of.h"
#include "support/gpu_hits.h"

#include <bit>

using namespace raysteps;

namespace {

// A cube of this side at x.
Box cube_on_x(float x, float side) {
    return {{x, 0, 0}, {x + side, side, side}};
}

std::vector<std::int32_t> firsts_of(const Bvh4& bvh, std::size_t node) {
    std::vector<std::int32_t> firsts;
    for (std::size_t i = bvh4_width * node; i < bvh4_width * (node + 1); ++i) {
        firsts.push_back(bvh.children[i].first);
    }
    return firsts;
}

float float_of(int bits) {
    return std::bit_cast<float>(bits);
}

const std::vector<glm::vec3>& hundred_triangles() {
    static const std::vector<glm::vec3> each = random_corners(9, 100);
    return each;
}

// What the check says of a good tree that was broken.
template <class Break>
std::string fault_of_four_after(const Break& broken) {
    Bvh4 bvh = collapse(build_bvh(hundred_triangles(), {}));
    broken(bvh);
    const std::vector<std::string> faults = check_bvh4(bvh, hundred_triangles());
    return faults.empty() ? "" : faults.front();
}

BvhNode& some_leaf(Bvh4& bvh) {
    return *std::find_if(bvh.children.begin(), bvh.children.end(),
                         [](const BvhNode& child) { return child.count > 1; });
}

BvhNode& some_inner(Bvh4& bvh) {
    return *std::find_if(bvh.children.begin(), bvh.children.end(), [](const BvhNode& child) {
        return child.count == 0 && child.first != no_bvh4_node;
    });
}

} // namespace

TEST_CASE("a binary tree of five leaves collapses to the nodes written down", "[06][bvh4][known]") {
    // 0: 1 and 2; 1: leaves 3 and 4; 2: 5 and leaf 6; 5: leaves 7 and 8. Node 1 is larger than
    // node 2, and node 5, which is opened last, than none that is left.
    Bvh bvh;
    bvh.nodes = {{cube_on_x(0, 9), 1, 0}, {cube_on_x(0, 5), 3, 0}, {cube_on_x(5, 4), 5, 0},
                 {cube_on_x(0, 2), 0, 1}, {cube_on_x(3, 2), 1, 1}, {cube_on_x(5, 2), 7, 0},
                 {cube_on_x(8, 1), 2, 1}, {cube_on_x(5, 1), 3, 1}, {cube_on_x(6, 1), 4, 1}};
    bvh.order = {4, 3, 2, 1, 0};
    const Bvh4 wide = collapse(bvh);
    CHECK(wide.parents == std::vector<std::int32_t>{no_bvh4_node, 1});
    // From 1 and 2: 3, 2 and 4; then 3, 5, 4 and 6. Of node 5, the second child is node 1.
    CHECK(firsts_of(wide, 0) == std::vector<std::int32_t>{0, 1, 1, 2});
    CHECK(wide.children[1].count == 0);
    CHECK(wide.children[1].box.upper == cube_on_x(5, 2).upper);
    CHECK(wide.children[2].count == 1);
    CHECK(firsts_of(wide, 1) == std::vector<std::int32_t>{3, 4, no_bvh4_node, no_bvh4_node});
    CHECK(wide.order == bvh.order);

    const BvhMeasures measures = measure_bvh4(wide, {});
    CHECK(measures.nodes == 2);
    CHECK(measures.leaves == 5);
    CHECK(measures.depth == 2);
    // A step costs 3, a test 1.5; the root's box is 9 wide and 2 high.
    const double root = surface_area(Box{{0, 0, 0}, {9, 2, 2}});
    const double expected = 3.0 + 3.0 * 24.0 / root + 1.5 * (24.0 + 24.0 + 6.0 + 6.0 + 6.0) / root;
    CHECK(std::abs(measures.cost - expected) < 1e-12);
}

TEST_CASE("a packed node of four has its planes by axis and its links", "[06][bvh4][known]") {
    const std::vector<glm::vec3> two{{0, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                     {10, 0, 0}, {10, 1, 0}, {10, 0, 1}};
    Bvh4 bvh;
    bvh.children = {{cube_on_x(0, 1), 0, 1}, {cube_on_x(9, 2), 1, 0},  {{}, no_bvh4_node, 0},
                    {{}, no_bvh4_node, 0},   {cube_on_x(10, 1), 1, 1}, {{}, no_bvh4_node, 0},
                    {{}, no_bvh4_node, 0},   {{}, no_bvh4_node, 0}};
    bvh.parents = {no_bvh4_node, 1};
    bvh.order = {1, 0};
    const PackedStructure packed = pack(bvh, two);
    const std::vector<glm::ivec4>& nodes = packed.integer_vectors.at("bvh4_nodes");
    CHECK(packed.numbers.at("bvh_node_count") == 2);
    REQUIRE(nodes.size() == 16);
    CHECK(float_of(nodes[0].x) == 0.0f); // lower planes across x
    CHECK(float_of(nodes[0].y) == 9.0f);
    CHECK(float_of(nodes[0].z) == no_end);
    CHECK(float_of(nodes[1].x) == 1.0f); // upper ones
    CHECK(float_of(nodes[1].y) == 11.0f);
    CHECK(float_of(nodes[1].w) == -no_end);
    CHECK(float_of(nodes[5].y) == 2.0f); // across z
    CHECK(nodes[6] == glm::ivec4(-2, 8, -1, -1));
    CHECK(nodes[7].x == -1);
    CHECK(nodes[14] == glm::ivec4(-3, -1, -1, -1));
    CHECK(nodes[15].x == 2); // behind child 1 of node 0
    const std::vector<glm::ivec4>& triangles = packed.integer_vectors.at("bvh_triangles");
    CHECK(triangles[0].w == 1);
    CHECK(triangles[1].w == 1); // the last of its leaf
    CHECK(bytes_of(packed) == 2 * 128 + 2 * 48);
}

TEST_CASE("a collapsed tree has no faults and the leaves of the binary one", "[06][bvh4]") {
    const std::vector<glm::vec3> many = random_corners(61, 2000);
    for (const BvhSplit split : all_splits) {
        const Bvh bvh = build_bvh(many, with_split(split));
        const Bvh4 wide = collapse(bvh);
        CAPTURE(static_cast<int>(split));
        CHECK(check_bvh4(wide, many).empty());
        const BvhMeasures two = measure_bvh(bvh, {});
        const BvhMeasures four = measure_bvh4(wide, {});
        CHECK(four.leaves == two.leaves);
        CHECK(four.longest_leaf == two.longest_leaf);
        CHECK(2 * four.nodes < two.nodes);
        CHECK(four.depth < two.depth);
    }
    CHECK(collapse({}).children.empty());
    CHECK(check_bvh4(collapse({}), {}).empty());
    const std::vector<glm::vec3> one(hundred_triangles().begin(), hundred_triangles().begin() + 3);
    const Bvh4 single = collapse(build_bvh(one, {}));
    CHECK(single.parents.size() == 1);
    CHECK(check_bvh4(single, one).empty());
}

TEST_CASE("every kind of broken tree of four is told", "[06][bvh4][check]") {
    CHECK(fault_of_four_after([](Bvh4&) {}).empty());
    const auto told = [](const std::string& fault, const auto& broken) {
        CHECK_THAT(fault_of_four_after(broken), contains_text(fault));
    };
    told("four places", [](Bvh4& bvh) { bvh.children.pop_back(); });
    told("a root unless", [](Bvh4& bvh) { bvh.order.pop_back(); });
    told("less than rays", [](Bvh4& bvh) { bvh.padding *= 0.5; });
    told("is the root", [](Bvh4& bvh) { bvh.parents[0] = 3; });
    told("does not stand behind it", [](Bvh4& bvh) { some_inner(bvh).first = 0; });
    told("does not stand behind it", [](Bvh4& bvh) { some_inner(bvh).first = 1 << 20; });
    told("does not stand behind it", [](Bvh4& bvh) { some_inner(bvh).count = -1; });
    told("another parent", [](Bvh4& bvh) { ++bvh.parents[2]; });
    told("reached 0 times", [](Bvh4& bvh) {
        const BvhNode last = some_inner(bvh);
        bvh.parents.push_back(no_bvh4_node);
        bvh.children.insert(bvh.children.end(), 4, last);
        for (std::size_t i = 0; i < 4; ++i) { // four leaves, so that they lead nowhere
            bvh.children[bvh.children.size() - 1 - i] = some_leaf(bvh);
        }
    });
    told("behind an empty place", [](Bvh4& bvh) { bvh.children[1] = {{}, no_bvh4_node, 0}; });
    told("more than 1", [](Bvh4& bvh) { bvh.leaf_triangles = 1; });
    told("of the list", [](Bvh4& bvh) { some_leaf(bvh).first = 99; });
    told("is in no leaf", [](Bvh4& bvh) { --some_leaf(bvh).count; });
    told("out of order", [](Bvh4& bvh) {
        const auto first = static_cast<std::size_t>(some_leaf(bvh).first);
        std::swap(bvh.order[first], bvh.order[first + 1]);
    });
    told("does not hold its child", [](Bvh4& bvh) { some_inner(bvh).box.upper.x -= 0.25f; });
    told("does not hold triangle", [](Bvh4& bvh) {
        BvhNode& leaf = some_leaf(bvh);
        const auto shrink = static_cast<float>(bvh.padding);
        leaf.box = {leaf.box.lower + shrink, leaf.box.upper - shrink};
    });
    told("has no first child", [](Bvh4& bvh) {
        for (std::size_t i = bvh.children.size() - 4; i < bvh.children.size(); ++i) {
            bvh.children[i] = {{}, no_bvh4_node, 0};
        }
    });
}

TEST_CASE("the family of four children builds with defaults of its own", "[06][bvh4]") {
    const StructureFamily family = family_of("bvh4");
    CHECK(family.name == "bvh4");
    const auto facts_with = [&](const std::map<std::string, std::string>& values) {
        std::map<std::string, double> facts;
        BuildRequest request;
        request.values = values;
        for (const Fact& fact : family.build(random_corners(71, 300), request).facts) {
            facts[fact.name] = fact.value;
        }
        return facts;
    };
    auto facts = facts_with({});
    CHECK(facts["longest_leaf"] <= 4);
    CHECK(facts["memory_bytes"] == 128 * facts["nodes"] + 48 * 300);
    CHECK(facts["memory_bytes"] <= 130 * 300);
    CHECK(facts["collapse_seconds"] < facts["build_seconds"]);
    CHECK(facts_with({{"leaf-triangles", "1"}})["leaves"] == 300);
    CHECK(error_of([&] { facts_with({{"bins", "many"}}); }).starts_with("--bins many: "));
}

TEST_CASE("a walk through four boxes a node gives the bits of the loop in double precision too",
          "[06][bvh4][agreement]") {
    const int seed = 62;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene =
        scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4), random_triangles(numbers, 200)));
    const mirror::SceneBuffers buffers(scene);
    for (const RayFamily& family : ray_families(numbers, scene.corners, 300)) {
        const PackedStructure packed = pack(collapse(bvh_for(scene, family.rays)), scene.corners);
        const std::vector<Hit> expected =
            hits_by(mirror::mirror_of<mirror::walks::every_triangle<double>>(buffers), family.rays);
        const auto walk = mirror::mirror_of<mirror::walks::bvh4<double>>(buffers, packed);
        CAPTURE(family.name);
        CHECK(count_hits(expected) > 50);
        CHECK(count_different(hits_by(walk, family.rays), expected) == 0);
        CHECK(count_different(hits_by(walk, family.rays, 1), expected) == 0);
    }
}

TEST_CASE("where boxes begin at the same distance the children of a node come by their number",
          "[06][bvh4][known]") {
    // The ray begins inside all four boxes, so that each is entered at t_min.
    Scene scene;
    for (int i = 0; i < 4; ++i) {
        const auto z = static_cast<float>(4 - i); // the last child is the nearest
        const Mesh one = triangle({-1, -1, z}, {1, -1, z}, {0, 1, z});
        scene.corners.insert(scene.corners.end(), one.corners.begin(), one.corners.end());
    }
    const Box all = pad(bounds_of(scene.corners), 6.0);
    Bvh4 bvh;
    bvh.parents = {no_bvh4_node};
    bvh.children = {{all, 0, 1}, {all, 1, 1}, {all, 2, 1}, {all, 3, 1}};
    bvh.order = {0, 1, 2, 3};
    const PackedStructure packed = pack(bvh, scene.corners);
    const mirror::SceneBuffers buffers(scene_of({scene.corners, {}}));
    auto walk = mirror::mirror_of<mirror::walks::bvh4<float, mirror::Recorder>>(buffers, packed);
    const Hit hit = mirror::from_mirror(
        walk.closest_hit(mirror::to_mirror<decltype(walk)>({{0, 0, 0}, {0, 0, 1}, 0.0f, no_end})));
    CHECK(hit.triangle == 3);
    std::vector<int> tested;
    for (const mirror::WalkEvent& event : walk.observer.events) {
        if (event.kind == mirror::WalkEvent::Kind::test) {
            tested.push_back(event.number);
        }
    }
    CHECK(tested == std::vector<int>{0, 1, 2, 3});
}
