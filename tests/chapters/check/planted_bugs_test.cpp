#include "catch.h"
#include "check/answers.h"
#include "check/inspection.h"
#include "check/why.h"
#include "files.h"
#include "hard_cases/aimed_rays.h"
#include "structure/bvh/check_bvh.h"
#include "support/error_of.h"

#include <algorithm>

using namespace raysteps;

namespace {

// Builders of other hands, whose boxes are tight.
BoxTree built_by(const std::string& builder) {
    return builder == "ours, tight" ? tight_tree(ball().corners) : embree_tree(ball().corners, {});
}

Inspection inspected(const BoxTree& tree, const Scene& scene = ball()) {
    return inspect(tree, scene, {}, [](double) {});
}

std::size_t some_leaf(const BoxTree& tree) {
    std::size_t leaf = 0;
    while (!is_leaf(tree, leaf) || tree.nodes[leaf].count < 2) {
        ++leaf;
    }
    return leaf;
}

std::vector<Ray> rays_at_triangles() {
    std::vector<Ray> rays;
    const std::vector<glm::vec3>& corners = ball().corners;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::vec3 middle = (corners[i] + corners[i + 1] + corners[i + 2]) / 3.0f;
        rays.push_back({3.0f * middle, -middle, 0.0f, 1e30f});
    }
    return rays;
}

std::size_t count_cause(const AnswerCheck& check, const std::string& cause) {
    return static_cast<std::size_t>(
        std::ranges::count_if(check.wrong, [&](const WrongAnswer& wrong) {
            return wrong.cause.find(cause) != std::string::npos;
        }));
}

bool guesses(const Inspection& inspection, const std::string& words) {
    return std::ranges::any_of(inspection.guesses, [&](const std::string& guess) {
        return guess.find(words) != std::string::npos;
    });
}

} // namespace

TEST_CASE("a sound tree of other hands has no fault, and its rays find what ours find",
          "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    const BoxTree tree = built_by(builder);
    const Inspection inspection = inspected(tree);
    CHECK(inspection.faults.kinds.empty());
    CHECK(inspection.guesses.empty());
    CHECK(count_of(inspection.remarks, remark_of_tight_box) > 0);
    CHECK(inspection.measured.front().measures.tree.references == 1520);
    const AnswerCheck check = check_walks(tree, ball(), rays_at_triangles());
    CHECK(check.rays == 1520);
    CHECK(check.judged == 1024);
    CHECK(count_faults(check) == 0);
}

TEST_CASE("a lost triangle is found, named, and missed by its rays", "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    BoxTree tree = built_by(builder);
    BvhNode& leaf = tree.nodes[some_leaf(tree)];
    --leaf.count;
    const std::int32_t lost = tree.order[static_cast<std::size_t>(leaf.first + leaf.count)];
    const Inspection inspection = inspected(tree);
    REQUIRE(inspection.faults.kinds.size() == 1);
    CHECK(inspection.faults.kinds[0].name == fault_of_lost_triangle);
    CHECK(inspection.faults.kinds[0].first ==
          std::vector<std::string>{"Triangle " + std::to_string(lost) + " is in no leaf."});
    const std::vector<Ray> rays = rays_at_triangles();
    const AnswerCheck check = check_walks(tree, ball(), rays);
    CHECK(count_cause(check, "no leaf lists it") > 0);
    CHECK(count_faults(check) == count_cause(check, "no leaf lists it"));
    CHECK_THAT(why_not(tree, ball().corners, rays[static_cast<std::size_t>(lost)], lost),
               contains_text("No leaf that can be reached lists triangle"));
}

TEST_CASE("a short box is found, named, and explained with both numbers", "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    BoxTree tree = built_by(builder);
    const std::size_t node = some_leaf(tree);
    Box& box = tree.nodes[node].box;
    const Box whole = box;
    box.upper.x = box.lower.x + 0.3f * (box.upper.x - box.lower.x);
    const Inspection inspection = inspected(tree);
    REQUIRE(inspection.faults.kinds.size() == 1);
    CHECK(inspection.faults.kinds[0].name == fault_of_leaf_box);
    CHECK_THAT(inspection.faults.kinds[0].first[0],
               starts_with_text("The box of node " + std::to_string(node)));
    const std::vector<Ray> rays = rays_at_triangles();
    const AnswerCheck check = check_walks(tree, ball(), rays);
    const std::string cause = "the box of node " + std::to_string(node) + " does not hold it";
    REQUIRE(count_cause(check, cause) > 0);
    CHECK(count_faults(check) == count_cause(check, cause));
    const WrongAnswer& wrong = check.wrong.front();
    const std::string why = why_not(tree, ball().corners, rays[wrong.ray], wrong.right.triangle);
    CAPTURE(why);
    CHECK_THAT(why, contains_text("Node " + std::to_string(node) + " left it out"));
    CHECK_THAT(why, contains_text("(0x"));
    // The padding that it names is enough, and half of it is not.
    const std::size_t place = why.find("Sides ") + 6;
    const float padding = std::stof(why.substr(place));
    const auto comes_with = [&](float room) {
        BoxTree grown = tree;
        grown.nodes[node].box = {box.lower - room, box.upper + room};
        return left_out(grown, paths_of(grown, 1520), ball().corners, rays[wrong.ray],
                        wrong.right.t, wrong.right.triangle)
                   .by == LeftOutBy::nothing;
    };
    CHECK(padding < whole.upper.x - whole.lower.x);
    CHECK(comes_with(1.01f * padding));
    CHECK_FALSE(comes_with(0.9f * padding));
}

TEST_CASE("a cycle is found, and no walk goes into it", "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    BoxTree tree = built_by(builder);
    std::size_t inner = tree.nodes.size() - 1;
    while (is_leaf(tree, inner)) {
        --inner;
    }
    tree.children[2 * inner] = 0;
    const Inspection inspection = inspected(tree);
    REQUIRE(count_of(inspection.faults, fault_of_cycle) == 1);
    CHECK(inspection.faults.kinds[0].first[0] ==
          "Node " + std::to_string(inner) + " leads back to node 0, from which it is reached.");
    CHECK(count_of(inspection.faults, fault_of_lost_node) > 0);
    CHECK_THAT(error_of([&] { bvh_of(tree, 1520); }), contains_text("is reached twice"));
}

TEST_CASE("swapped children are found, and both are named", "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    BoxTree tree = built_by(builder);
    // One leaf from either half of the ball.
    const auto leaf_below = [&](std::size_t node) {
        while (!is_leaf(tree, static_cast<std::size_t>(children_of(tree, node)[0]))) {
            node = static_cast<std::size_t>(children_of(tree, node)[0]);
        }
        return node;
    };
    const std::size_t one = leaf_below(static_cast<std::size_t>(tree.children[0]));
    const std::size_t other = leaf_below(static_cast<std::size_t>(tree.children[1]));
    std::swap(tree.children[2 * one], tree.children[2 * other]);
    const Inspection inspection = inspected(tree);
    CHECK(count_of(inspection.faults, fault_of_child_box) == 2);
    REQUIRE(inspection.guesses.size() == 1);
    CHECK(guesses(inspection, "Two children are swapped"));
    CHECK(guesses(inspection, "node " + std::to_string(one) + " has"));
    CHECK(guesses(inspection, "node " + std::to_string(other) + " has"));
    CHECK(count_faults(check_walks(tree, ball(), rays_at_triangles())) > 0);
}

TEST_CASE("numbers that are shifted by dropped faces are found and named", "[check][planted]") {
    const std::string builder = GENERATE("ours, tight", "Embree");
    CAPTURE(builder);
    Scene scene = ball();
    scene.left_out = {100, 700}; // as if the file had two more
    BoxTree tree = built_by(builder);
    for (std::int32_t& triangle : tree.order) {
        triangle += triangle >= 699 ? 2 : triangle >= 100 ? 1 : 0;
    }
    const Inspection inspection = inspected(tree, scene);
    CHECK(count_of(inspection.faults, fault_of_leaf_box) > 500);
    CHECK(count_of(inspection.faults, fault_of_triangle) == 2);
    CHECK(guesses(inspection, "shifted by dropped faces: they count the 2"));
    CHECK(guesses(inspection, "triangle 100"));
    for (std::int32_t& triangle : tree.order) {
        triangle = 1 + (triangle - (triangle > 700 ? 2 : triangle > 100 ? 1 : 0));
    }
    CHECK(guesses(inspected(tree), "count from 1"));
}

TEST_CASE("every other kind of fault is told, and each of them is counted", "[check][planted]") {
    const auto count_after = [](const std::string& kind, const auto& broken) {
        BoxTree tree = tight_tree(ball().corners);
        broken(tree);
        return count_of(find_faults(tree, ball().corners, 0.0).faults, kind);
    };
    CHECK(count_after(fault_of_link, [](BoxTree& tree) { tree.children[0] = 999999; }) == 1);
    CHECK(count_after(fault_of_link, [](BoxTree& tree) { tree.children[0] = -7; }) == 1);
    CHECK(count_after(fault_of_second_parent,
                      [](BoxTree& tree) { tree.children[0] = tree.children[1]; }) == 1);
    CHECK(count_after(fault_of_lost_node, [](BoxTree& tree) {
              tree.nodes.emplace_back();
              tree.children.insert(tree.children.end(), 2, no_child);
          }) == 1);
    CHECK(count_after(fault_of_numbers, [](BoxTree& tree) {
              tree.nodes[some_leaf(tree)].box.lower.y = std::nanf("");
          }) == 1);
    CHECK(count_after(fault_of_sides, [](BoxTree& tree) {
              std::swap(tree.nodes[0].box.lower.x, tree.nodes[0].box.upper.x);
          }) == 1);
    CHECK(count_after(fault_of_empty_leaf,
                      [](BoxTree& tree) { tree.nodes[some_leaf(tree)].count = 0; }) == 1);
    CHECK(count_after(fault_of_range,
                      [](BoxTree& tree) { tree.nodes[some_leaf(tree)].first = 1519; }) == 1);
    CHECK(count_after(fault_of_triangle, [](BoxTree& tree) { tree.order[3] = 1520; }) == 1);
    CHECK(count_after(fault_of_double, [](BoxTree& tree) { tree.order[3] = tree.order[2]; }) == 1);
    CHECK(count_after(fault_of_lost_triangle, [](BoxTree& tree) {
              tree.nodes.clear();
              tree.children.clear();
          }) == 1520);
    const Inspection all = inspected([] {
        BoxTree tree = tight_tree(ball().corners);
        std::ranges::fill(tree.order, 5000);
        return tree;
    }());
    CHECK(count_of(all.faults, fault_of_triangle) == 1520);
    CHECK(all.faults.kinds[0].first.size() == 10);
}

TEST_CASE("spatial splits need boxes that cover a triangle together", "[check][planted]") {
    const std::vector<glm::vec3> one{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    BoxTree tree;
    tree.splits = true;
    tree.nodes = {{{{0, 0, 0}, {4, 4, 0}}, 0, 0},
                  {{{0, 0, 0}, {2, 4, 0}}, 0, 1},
                  {{{2, 0, 0}, {4, 2, 0}}, 1, 1}};
    tree.children = {1, 2, -1, -1, -1, -1};
    tree.order = {0, 0};
    CHECK(find_faults(tree, one, 0.0).faults.kinds.empty());
    tree.nodes[2].box.upper.y = 1.0f;
    CHECK(count_of(find_faults(tree, one, 0.0).faults, fault_of_leaf_box) == 1);
    tree.nodes[2].box.upper.y = 2.0f;
    tree.splits = false;
    CHECK(count_of(find_faults(tree, one, 0.0).faults, fault_of_double) == 1);
}
