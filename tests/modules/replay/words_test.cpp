#include "catch.h"
#include "basics/error.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/replay/shader_line.h"
#include "replayed.h"

using namespace raysteps;

TEST_CASE("every line that decides a step stands once in its shader", "[replay][words]") {
    for (const LineMarker& marker : all_markers()) {
        CAPTURE(marker.file, marker.words);
        const ShaderLine line = find_line(marker);
        CHECK(line.number > 0);
        CHECK(contains_text(marker.words).match(line.text));
    }
    CHECK_THROWS_WITH(find_line({"core/hit.glsl", "no such words"}),
                      contains_text("core/hit.glsl"));
    CHECK_THROWS_AS(find_line({"core/hit.glsl", "real"}), MachineError);
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
    CHECK(deciding_line(walk, 0).file == "structure/bvh/bvh_skip.glsl");
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
