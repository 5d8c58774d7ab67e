#include "basics/error.h"
#include "catch.h"
#include "replayed.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/replay/shader_line.h"

using namespace raysteps;

TEST_CASE("the line that decides a step is found for every step of every walk", "[replay][words]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 20);
    for (const Ray& ray : axis_parallel_rays(numbers, scene.corners, 20)) {
        rays.push_back(ray);
    }
    for (const std::string& structure : recorded_structures()) {
        CAPTURE(structure);
        const Replayed replayed(scene, structure, reach_of(rays, scene.corners));
        std::size_t steps = 0;
        std::size_t in_words_of_its_own = 0;
        for (const Ray& ray : rays) {
            const RecordedWalk walk = replayed.recorder.record(ray, Question::nearest);
            for (std::size_t i = 0; i < std::min<std::size_t>(walk.steps.size(), 40);
                 ++i, ++steps) {
                const ShaderLine line = deciding_line(walk, i);
                in_words_of_its_own += line.text.starts_with("observe_visit(") ? 1 : 0;
            }
        }
        CHECK(steps > 100);
        CHECK(in_words_of_its_own == 0);
    }
    CHECK_THROWS_WITH(find_line("grid", {"no such words"}), contains_text("grid/grid.glsl"));
    CHECK_THROWS_AS(find_line("grid", {"real"}), MachineError); // stands there often
    CHECK_THROWS_WITH(find_line("gird", {"real"}), contains_text("gird"));
}

TEST_CASE("a walk through a grid of two cells is told cell by cell", "[replay][words]") {
    const Replayed grid(two_triangles(), "grid", 0.0f, {{"resolution", "2"}});
    REQUIRE(grid.cells.grid_cells == glm::ivec3(2, 2, 1));
    Ray ray{{-2.0f, -0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, 0.0f, no_end};
    const RecordedWalk across = grid.recorder.record(ray, Question::nearest);
    REQUIRE(across.steps.size() == 2);
    CHECK(sentence_of(grid.cells, across, 0) ==
          "step 1: cell (0,0,0), t 1 to 2, leaves through +x, 2 triangles tested, no hit, on to "
          "cell (1,0,0)");
    CHECK(sentence_of(grid.cells, across, 1) ==
          "step 2: cell (1,0,0), t 2 to 3, leaves through +x, 2 triangles tested, no hit; the "
          "end, the ray has left the structure: no hit");
    CHECK(deciding_line(across, 0).file == "structure/grid/grid.glsl");
    CHECK(contains_text("first_axis(leaves)").match(deciding_line(across, 0).text));
    CHECK(contains_text("i >= grid_cells[axis]").match(deciding_line(across, 1).text));
    CHECK(deciding_line(across, 0).exercise.empty());
    CHECK(deciding_line(across, 1).exercise == "4.4");
}

TEST_CASE("a grid with a mailbox says what it passed over", "[replay][words]") {
    const Replayed grid(two_triangles(), "grid_mailbox", 0.0f, {{"resolution", "2"}});
    const Ray ray{{-2.0f, -0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, 0.0f, no_end};
    const RecordedWalk across = grid.recorder.record(ray, Question::nearest);
    REQUIRE(across.steps.size() == 2);
    CHECK(contains_text("0 triangles tested, 2 passed over")
              .match(sentence_of(grid.cells, across, 1)));
}

TEST_CASE("a walk through a BVH says what it meets and leaves out", "[replay][words]") {
    const Replayed tree(two_triangles(), "bvh_ordered", 0.0f, {{"leaf-triangles", "1"}});
    REQUIRE(tree.cells.cells.size() == 3);
    const RecordedWalk walk = tree.recorder.record(along_z, Question::nearest);
    REQUIRE(walk.steps.size() == 3);
    CHECK(sentence_of(tree.cells, walk, 0) == "step 1: node 0, t 1 to 2, box met, on to leaf 1");
    CHECK(sentence_of(tree.cells, walk, 1) ==
          "step 2: leaf 1, t 1 to 1, 1 triangle tested, hit triangle 0 at t 1, on to leaf 2");
    CHECK(sentence_of(tree.cells, walk, 2) ==
          "step 3: leaf 2, box begins at t 2, behind the hit at t 1, left out; the end, nothing "
          "is left to visit: triangle 0 at t 1");
    CHECK(deciding_line(walk, 0).file == "structure/bvh/bvh_ordered.glsl");
    CHECK(deciding_line(walk, 1).file == "structure/bvh/bvh_leaf.glsl");
    CHECK(contains_text("meets_bvh_node").match(deciding_line(walk, 2).text));
    const RecordedWalk any = tree.recorder.record(along_z, Question::any);
    REQUIRE(any.steps.size() == 2);
    CHECK(any.ending == Ending::found);
    CHECK(contains_text("near_enough").match(deciding_line(any, 1).text));
}

TEST_CASE("a ray of the other direction meets the other triangle first in octants",
          "[replay][words]") {
    const Replayed tree(two_triangles(), "bvh_ordered", 0.0f, {{"leaf-triangles", "1"}});
    const Ray back{{0.0f, 0.0f, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end};
    const RecordedWalk walk = tree.recorder.record(back, Question::nearest);
    REQUIRE(walk.steps.size() == 3);
    CHECK(walk.steps[1].cell == 2); // in octant 0 it comes last
    CHECK(walk.steps[2].cell == 1);
    CHECK(walk.hit.triangle == 1);
}

TEST_CASE("a kd-tree tells on which side of a plane the ray is", "[replay][words]") {
    const Replayed tree(two_triangles(4.0f), "kd_restart", 0.0f,
                        {{"leaf-triangles", "1"}, {"split", "median"}});
    const RecordedWalk walk = tree.recorder.record(along_z, Question::nearest);
    REQUIRE(walk.steps.size() >= 2);
    REQUIRE(walk.steps.front().outcome == Outcome::entered);
    CHECK(contains_text("the plane across z comes at t").match(sentence_of(tree.cells, walk, 0)));
    CHECK(deciding_line(walk, 0).file == "structure/kd_tree/kd_descent.glsl");
    CHECK(contains_text("no nearer hit can come: triangle 0 at t 1")
              .match(sentence_of(tree.cells, walk, walk.steps.size() - 1)));
}
