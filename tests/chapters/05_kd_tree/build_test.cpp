#include "catch.h"
#include "kd_hits.h"
#include "scene/shapes.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "structure/kd_tree/kd_split.h"
#include "structure/kd_tree/kd_tree.h"
#include "structure/structure.h"
#include "support/error_of.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

using namespace raysteps;

namespace {

std::string first_fault(const KdTree& tree, std::span<const glm::vec3> corners) {
    const std::vector<std::string> faults = check_kd_tree(tree, corners);
    return faults.empty() ? "" : faults.front();
}

bool same_tree(const KdTree& a, const KdTree& b) {
    bool same = a.nodes.size() == b.nodes.size() && a.references == b.references &&
                a.ropes == b.ropes && a.padding == b.padding;
    for (std::size_t i = 0; same && i < a.nodes.size(); ++i) {
        same = a.nodes[i].axis == b.nodes[i].axis &&
               same_bits(a.nodes[i].split, b.nodes[i].split) &&
               a.nodes[i].first_child == b.nodes[i].first_child &&
               a.nodes[i].first_reference == b.nodes[i].first_reference &&
               same_bits(a.boxes[i].lower, b.boxes[i].lower) &&
               same_bits(a.boxes[i].upper, b.boxes[i].upper);
    }
    return same;
}

} // namespace

TEST_CASE("a tree of no triangle is one empty leaf and every ray misses", "[05][build]") {
    const KdTree tree = build_kd_tree({}, {});
    CHECK(first_fault(tree, {}).empty());
    CHECK(tree.nodes.size() == 1);
    CHECK(tree.references.empty());
    RandomNumbers numbers(1);
    const KdAgreement agreement = agreement_of(Scene{}, tree, random_rays(numbers, 100));
    CHECK(agreement.hits == 0);
    CHECK(agrees(agreement));
}

TEST_CASE("a tree of one triangle is one leaf", "[05][build]") {
    const Scene scene = scene_of(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    const KdTree tree = build_kd_tree(scene.corners, {});
    CHECK(first_fault(tree, scene.corners).empty());
    CHECK(tree.nodes.size() == 1);
    const std::vector<Ray> rays{{{0.25f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end}};
    const KdAgreement agreement = agreement_of(scene, tree, rays);
    CHECK(agreement.hits == 1);
    CHECK(agrees(agreement));
}

TEST_CASE("two heaps of triangles are parted at the edge of one of them", "[05][build]") {
    // Between x = 1 and x = 9 there is nothing: the cheapest planes are the ends of that gap, one
    // padding and a rounding outside the triangles.
    RandomNumbers numbers(2);
    Mesh mesh;
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 corner(i % 2 == 0 ? 0.0f : 9.0f, numbers.unit(), numbers.unit());
        mesh =
            join(mesh, triangle(corner, corner + glm::vec3(1, 0, 0), corner + glm::vec3(0, 1, 1)));
    }
    const KdTree tree = build_kd_tree(mesh.corners, {});
    CHECK(first_fault(tree, mesh.corners).empty());
    CHECK(tree.nodes[0].axis == 0);
    const auto split = static_cast<double>(tree.nodes[0].split);
    const double off = std::min(std::abs(split - 1.0), std::abs(split - 9.0));
    CHECK(off >= tree.padding);
    CHECK(off < tree.padding + 2e-6); // the spacing of floats at 9 is 9.5e-7
}

TEST_CASE("the cost of a plane is that of the surface-area heuristic", "[05][build]") {
    // A box of 4 x 2 x 2 and one triangle in its first quarter, with bounds from x = 0 to 1.
    const Box box{glm::vec3(0.0f), glm::vec3(4.0f, 2.0f, 2.0f)};
    KdEvents events;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        events[axis] = {make_event(0.0f, 0, KdEventKind::start),
                        make_event(axis == 0 ? 1.0f : 2.0f, 0, KdEventKind::end)};
    }
    KdOptions options;
    options.traversal_cost = 2.0;
    options.intersection_cost = 10.0;
    options.empty_bonus = 0.5;
    CHECK(surface_area(box) == 40.0);
    const KdPlane plane = cheapest_plane(events, box, 1e-3, options);
    CHECK(plane.axis == 0);
    CHECK(plane.position == 1.0f);
    CHECK(plane.lower_count == 1);
    CHECK(plane.upper_count == 0);
    // The first quarter has half an area of 4 + 2 + 2 = 8: (1 - 0.5) * (2 + 10 * 8 / 20).
    CHECK(plane.cost == Approx(3.0));
}

TEST_CASE("no plane stands nearer to a side than eight paddings", "[05][build]") {
    const Box box{glm::vec3(0.0f), glm::vec3(1.0f)};
    KdEvents events;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        events[axis] = {make_event(0.0f, 0, KdEventKind::start),
                        make_event(0.0625f, 0, KdEventKind::end)};
    }
    CHECK(was_found(cheapest_plane(events, box, 0.0625 / 8.0, {})));
    CHECK_FALSE(was_found(cheapest_plane(events, box, 0.0625 / 7.9, {})));
    CHECK(was_found(middle_plane(events, box, 0.5 / 8.0)));
    CHECK_FALSE(was_found(middle_plane(events, box, 0.5 / 7.9)));
}

TEST_CASE("the middle is split where the rule says so", "[05][build]") {
    const Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4);
    Mesh wide = mesh;
    for (glm::vec3& corner : wide.corners) {
        corner.y *= 3.0f;
    }
    const KdTree tree = build_kd_tree(wide.corners, with_median());
    CHECK(tree.nodes[0].axis == 1);
    // The corners of an icosahedron come in pairs on both sides of the centre, but for rounding.
    CHECK(tree.nodes[0].split == Approx(0.0).margin(1e-5));
}

TEST_CASE("a leaf holds no more than leaf triangles unless a stop rule says so", "[05][build]") {
    RandomNumbers numbers(3);
    const Mesh mesh = random_triangles(numbers, 500);
    KdOptions options;
    options.depth_limit = 5;
    CHECK(measure_kd_tree(build_kd_tree(mesh.corners, options), options).depth == 5);
    options.depth_limit = 0;
    const KdMeasures root_only = measure_kd_tree(build_kd_tree(mesh.corners, options), options);
    CHECK(root_only.nodes == 1);
    CHECK(root_only.longest_leaf == 500);
    CHECK(root_only.cost == Approx(500 * options.intersection_cost));
    options.depth_limit = -1;
    const KdMeasures usual = measure_kd_tree(build_kd_tree(mesh.corners, options), options);
    CHECK(usual.depth <= 8 + 1.3 * std::log2(500.0));
    CHECK(usual.cost < root_only.cost / 5);
    options.leaf_triangles = 500;
    CHECK(measure_kd_tree(build_kd_tree(mesh.corners, options), options).nodes == 1);
}

TEST_CASE("the heuristic makes a cheaper tree than the median", "[05][build]") {
    RandomNumbers numbers(4);
    Mesh mesh = random_triangles(numbers, 200);
    // A small thing in a large room.
    mesh = join(mesh, box(glm::vec3(-50.0f), glm::vec3(50.0f)));
    const KdOptions by_area;
    const double area = measure_kd_tree(build_kd_tree(mesh.corners, by_area), by_area).cost;
    const double median = measure_kd_tree(build_kd_tree(mesh.corners, with_median()), by_area).cost;
    CHECK(area < median);
}

TEST_CASE("a tree does not depend on the number of threads", "[05][build]") {
    const Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 24); // 11,520 triangles: many branches
    KdOptions options;
    options.threads = 1;
    const KdTree alone = build_kd_tree(mesh.corners, options);
    CHECK(first_fault(alone, mesh.corners).empty());
    for (const unsigned threads : {2U, 3U, 8U}) {
        options.threads = threads;
        CHECK(same_tree(alone, build_kd_tree(mesh.corners, options)));
    }
}

TEST_CASE("a tree that is grown by bins costs at most 3 percent more and gives the same hits",
          "[05][build][bins]") {
    RandomNumbers numbers(8);
    for (const Mesh& mesh : {teapot_in_a_stadium(numbers), random_triangles(numbers, 4000)}) {
        KdOptions options;
        const double exact = measure_kd_tree(build_kd_tree(mesh.corners, options), options).cost;
        options.binned_above = 0;
        options.most_sorted = 64;
        const KdTree tree = build_kd_tree(mesh.corners, options);
        CHECK(first_fault(tree, mesh.corners).empty());
        CHECK(measure_kd_tree(tree, options).cost <= 1.03 * exact);
        options.threads = 1;
        CHECK(same_tree(tree, build_kd_tree(mesh.corners, options)));
        const Scene scene = scene_of(mesh);
        const std::vector<Ray> rays = random_rays(numbers, 200);
        CHECK(agrees(agreement_of(scene, tree_for(scene, rays, options), rays)));
    }
}

TEST_CASE("a plane of bins counts the parts that end before it and those that begin behind it",
          "[05][build][bins]") {
    // At both ends of bins: nine slabs of half a unit, in a box whose bins are two units wide.
    const Box box{glm::vec3(0.0f), glm::vec3(128.0f)};
    std::vector<KdPart> parts;
    for (int i = 0; i < 9; ++i) {
        const float start = 1.5f + 0.5f * static_cast<float>(i);
        parts.push_back(
            {{glm::vec3(start, 0.0f, 0.0f), glm::vec3(start + 0.5f, 128.0f, 128.0f)}, i});
    }
    KdOptions options;
    options.empty_bonus = 0.0;
    const KdPlane plane = binned_plane(parts, box, 1e-6, options);
    CHECK(plane.axis == 0);
    std::size_t lower = 0;
    std::size_t upper = 0;
    for (const KdPart& part : parts) {
        lower += part.bounds.lower.x < plane.position ? 1 : 0;
        upper += part.bounds.upper.x > plane.position ? 1 : 0;
    }
    CHECK(plane.lower_count == lower);
    CHECK(plane.upper_count == upper);
    CHECK(plane.position == 6.0f); // all that is behind it is empty
    options.empty_bonus = 0.2;
    parts.push_back({{glm::vec3(127.0f, 0.0f, 0.0f), glm::vec3(128.0f)}, 9});
    CHECK(binned_plane(parts, box, 1e-6, options).position == 6.0f);
}

TEST_CASE("random triangles on a lattice make a tree without faults", "[05][build][property]") {
    REQUIRE(rc::check([] {
        const auto seed = *rc::gen::inRange(0, 1 << 20);
        const auto count = *rc::gen::inRange(0, 40);
        const auto steps = *rc::gen::inRange(1, 6); // few: many equal coordinates, some flat ones
        KdOptions options =
            *rc::gen::elementOf(std::vector<KdOptions>{{}, with_median(), with_small_leaves()});
        options.bad_splits = *rc::gen::inRange(0, 4);
        RandomNumbers numbers(seed);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 3 * count; ++i) {
            glm::vec3 corner;
            for (int axis = 0; axis < 3; ++axis) {
                corner[axis] = static_cast<float>(numbers.below(steps)) - 1.0f;
            }
            corners.push_back(corner);
        }
        RC_ASSERT(first_fault(build_kd_tree(corners, options), corners).empty());
    }));
}

TEST_CASE("triangles whose sizes double make a tree without faults", "[05][build]") {
    std::vector<glm::vec3> corners;
    for (int i = -30; i < 40; ++i) {
        const float size = std::ldexp(1.0f, i);
        corners.insert(corners.end(), {{size, 0, 0}, {2 * size, 0, 0}, {size, size, size}});
    }
    for (const KdOptions& options : {KdOptions{}, with_median(), with_small_leaves()}) {
        CHECK(first_fault(build_kd_tree(corners, options), corners).empty());
    }
}

TEST_CASE("extents whose areas are no floats make a tree without faults", "[05][build]") {
    RandomNumbers numbers(5);
    Mesh mesh = random_triangles(numbers, 200);
    for (glm::vec3& corner : mesh.corners) {
        corner *= 1e18f;
    }
    const KdTree tree = build_kd_tree(mesh.corners, {});
    CHECK(first_fault(tree, mesh.corners).empty());
    CHECK(tree.nodes.size() > 100);
}

TEST_CASE("a tree that would be too large is refused", "[05][build]") {
    RandomNumbers numbers(6);
    const Mesh mesh = random_triangles(numbers, 5000);
    KdOptions options;
    options.most_bytes = std::size_t{1} << 16;
    CHECK_THAT(error_of([&] { build_kd_tree(mesh.corners, options); }),
               contains_text("--leaf-triangles"));
    options.most_bytes = std::size_t{1} << 30;
    const KdTree tree = build_kd_tree(mesh.corners, options);
    // The limit counts no less than the tree takes.
    options.most_bytes = bytes_of(tree) - 200;
    CHECK_FALSE(error_of([&] { build_kd_tree(mesh.corners, options); }).empty());
}

TEST_CASE("a tree that OpenGL does not read is refused as soon as that is known", "[05][build]") {
    RandomNumbers numbers(6);
    const Mesh mesh = random_triangles(numbers, 5000);
    const KdTree tree = build_kd_tree(mesh.corners, {});
    // Of no packed array has the tree more texels than the limit counts, and of one as many.
    std::size_t most = 0;
    const PackedStructure packed = pack(tree);
    for (const auto& [name, texels] : packed.integers) {
        most = std::max(most, texels.size());
    }
    for (const auto& [name, texels] : packed.integer_vectors) {
        most = std::max(most, texels.size());
    }
    for (const auto& [name, texels] : packed.vectors) {
        most = std::max(most, texels.size());
    }
    BuildRequest request{.most_texels = static_cast<std::int64_t>(most)};
    CHECK_NOTHROW(family_of("kd_ropes").build(mesh.corners, request));
    request.most_texels -= 1;
    CHECK_THROWS_AS(family_of("kd_ropes").build(mesh.corners, request), MachineError);
    CHECK_THROWS_WITH(family_of("kd_ropes").build(mesh.corners, request),
                      contains_text("OpenGL reads at most") && contains_text("--leaf-triangles"));
}

TEST_CASE("corners that are no numbers are refused", "[05][build]") {
    std::vector<glm::vec3> corners(6, glm::vec3(1.0f));
    for (const float wrong : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1.9e18f}) {
        corners[4].y = wrong;
        CHECK_THAT(error_of([&] { build_kd_tree(corners, {}); }), contains_text("Triangle 1"));
    }
}

TEST_CASE("the kd family reads its options and tells its facts", "[05][build]") {
    const Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3);
    const auto build = [&](const std::string& name, const std::string& value) {
        return family_of("kd_ropes").build(mesh.corners, {0.0f, {{name, value}}});
    };
    const auto fact = [](const BuiltStructure& built, const std::string& name) {
        for (const Fact& each : built.facts) {
            if (each.name == name) {
                return each.value;
            }
        }
        return -1.0;
    };
    CHECK(fact(build("depth", "3"), "depth") == 3.0);
    CHECK(fact(build("leaf-triangles", "1000"), "nodes") == 1.0);
    CHECK(fact(build("split", "median"), "references") !=
          fact(build("split", "area"), "references"));
    for (const std::string name : {"build_seconds", "memory_bytes", "nodes", "leaves", "references",
                                   "references_per_triangle", "expected_cost"}) {
        CAPTURE(name);
        CHECK(fact(build("depth", "-1"), name) >= 0.0);
    }
    CHECK(fact(build("depth", "-1"), "references_per_triangle") >= 1.0);
    for (const auto& [name, value] :
         std::vector<std::pair<std::string, std::string>>{{"split", "best"},
                                                          {"empty-bonus", "2"},
                                                          {"depth", "3.5"},
                                                          {"depth", "100"},
                                                          {"traversal-cost", "nan"},
                                                          {"intersection-cost", "0"},
                                                          {"leaf-triangles", ""}}) {
        CHECK_THAT(error_of([&, &name = name, &value = value] { build(name, value); }),
                   starts_with_text("--" + name + " " + value + ": "));
    }
}
