#include "basics/error.h"
#include "basics/text.h"
#include "catch.h"
#include "shown.h"
#include "structure/bvh/build_bvh.h"
#include "structure/tree_file/tree_file.h"
#include "support/scratch_folder.h"
#include "visualizer/finding.h"
#include "visualizer/keys.h"

#include <set>

using namespace raysteps;
using namespace raysteps::view;

namespace {

const RecordedWalk& walk_of(const Stage& stage, const State& state) {
    return *walk_in(*stage.panes().front(), state);
}

const Cell& cell_of(const Stage& stage, int number) {
    return stage.panes().front()->cells.cells.at(static_cast<std::size_t>(number));
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
}

State after_keys(State state, const Stage& stage, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        state = after_key(state, stage, key);
    }
    return state;
}

} // namespace

TEST_CASE("keys lead to the parent, the child and the siblings of the marked cell",
          "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state("bvh4");
    stage.show(state);
    state.selected = 0;
    const State child = after_key(state, stage, "Control+Down");
    REQUIRE(child.selected > 0);
    CHECK(cell_of(stage, child.selected).parent == 0);
    std::set<int> siblings{child.selected};
    State next = after_key(child, stage, "Control+Right");
    while (next.selected != child.selected) {
        CHECK(cell_of(stage, next.selected).parent == 0);
        CHECK(siblings.insert(next.selected).second);
        next = after_key(next, stage, "Control+Right");
    }
    CHECK(siblings.size() > 1);
    const State before = after_key(child, stage, "Control+Left");
    CHECK(after_key(before, stage, "Control+Right").selected == child.selected);
    CHECK(after_key(before, stage, "Control+Up").selected == 0);
    CHECK(after_key(state, stage, "Control+Up").selected == 0);
    CHECK(after_key(mirrors_state(), stage, "Control+Up").selected == no_cell);
}

TEST_CASE("a cell is found by its number, and what is none is told", "[visualizer][keys]") {
    Stage stage;
    const State state = mirrors_state();
    stage.show(state);
    CHECK(with_found(state, stage, "12").selected == 12);
    CHECK_THAT(find_cell(stage, state, "99999").words,
               contains_text("no such cell: they are 0 to"));
    CHECK_THAT(find_cell(stage, state, "t99999").words, contains_text("no such triangle"));
    CHECK_THAT(find_cell(stage, state, "").words, contains_text("t17 is a triangle"));
    CHECK_THROWS_AS(with_found(state, stage, "1e9,0,0"), InputError);
}

TEST_CASE("a triangle is found in every cell that lists it", "[visualizer][keys]") {
    for (const std::string structure : {"grid", "kd_ropes", "bvh_ordered", "bvh4", "half_bvh"}) {
        CAPTURE(structure);
        Stage stage;
        State state = mirrors_state(structure);
        stage.show(state);
        const RecordedWalk& walk = walk_of(stage, state);
        const int triangle = walk.hit.triangle;
        REQUIRE(triangle != no_triangle);
        int hit_in = no_cell;
        for (const Step& step : walk.steps) {
            for (const TriangleTest& test : tests_of(walk, step)) {
                hit_in = test.best && test.triangle == triangle ? step.cell : hit_in;
            }
        }
        const auto corners = std::span(stage.scene().corners).subspan(3 * triangle, 3);
        std::set<int> cells;
        const std::string text = "t" + std::to_string(triangle);
        while (cells.insert((state = with_found(state, stage, text)).selected).second) {
            CHECK(cell_of(stage, state.selected).leaf);
            CHECK(overlap(cell_of(stage, state.selected).box, bounds_of(corners)));
        }
        CHECK(cells.contains(hit_in));
    }
}

TEST_CASE("a point is found in the smallest cell around it", "[visualizer][keys]") {
    Stage stage;
    const State state = mirrors_state("kd_ropes");
    stage.show(state);
    const std::vector<Cell>& cells = stage.panes().front()->cells.cells;
    for (std::size_t i = 0; i < cells.size(); i += 7) {
        if (!cells[i].leaf) {
            continue;
        }
        // Leaves of a kd-tree share no inner point.
        const glm::vec3 middle = 0.5f * (cells[i].box.lower + cells[i].box.upper);
        const std::string text =
            shortest_text(middle.x) + "," + shortest_text(middle.y) + "," + shortest_text(middle.z);
        CAPTURE(i, text);
        CHECK(find_cell(stage, state, text).cell == static_cast<int>(i));
    }
}

TEST_CASE("a walk goes on to the marked cell, and to the tests of its hit", "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const RecordedWalk& walk = walk_of(stage, state);
    state = after_keys(state, stage, {"Home", "n", "n", "n", "Return"});
    CHECK(state.selected == walk.steps[3].cell);
    CHECK(after_keys(state, stage, {"Home", "g"}).step == 3);
    const State tested = after_keys(state, stage, {"Home", "a"});
    const auto tests = tests_of(walk, walk.steps.at(static_cast<std::size_t>(tested.step)));
    CHECK(std::any_of(tests.begin(), tests.end(), [&](const TriangleTest& test) {
        return test.triangle == walk.hit.triangle;
    }));
    state.selected = no_cell;
    CHECK(after_key(state, stage, "g").step == state.step);
    state.selected = static_cast<int>(stage.panes().front()->cells.cells.size()) - 1;
    const bool is_visited =
        std::any_of(walk.steps.begin(), walk.steps.end(),
                    [&](const Step& step) { return step.cell == state.selected; });
    REQUIRE_FALSE(is_visited);
    CHECK(after_key(state, stage, "g").step == state.step);
}

TEST_CASE("the next pixel is found in which a broken tree leads elsewhere", "[visualizer][keys]") {
    const ScratchFolder folder("visualizer_differs");
    Stage sound;
    State state = mirrors_state();
    sound.show(state);
    CHECK(after_key(state, sound, "l").pixel == state.pixel);
    // A triangle that this pixel sees is in no leaf.
    const int lost = walk_of(sound, state).hit.triangle;
    BoxTree tree = box_tree_of(build_bvh(sound.scene().corners, {}));
    *std::find(tree.order.begin(), tree.order.end(), lost) = lost == 0 ? 1 : 0;
    write_tree_file(folder / "lost.rstree", {"a test", tree});
    state.structures = {"bvh_ordered:tree=" + (folder / "lost.rstree").string(), "bvh_skip"};
    const glm::ivec2 seen = *state.pixel;
    state.pixel.reset();
    Stage stage;
    stage.show(state);
    const State first = after_key(state, stage, "l");
    REQUIRE(first.pixel);
    stage.show(first);
    const Hit one = walk_of(stage, first).hit;
    const Hit other = walk_in(*stage.panes().back(), first)->hit;
    CHECK(one.triangle != other.triangle);
    CHECK(other.triangle == lost);
    // Row by row: not behind the pixel that is known, from whose next one the search goes round.
    CHECK(64 * first.pixel->y + first.pixel->x <= 64 * seen.y + seen.x);
    State again = first;
    std::set<std::pair<int, int>> pixels;
    do {
        pixels.insert({again.pixel->x, again.pixel->y});
        again = after_key(again, stage, "l");
    } while (again.pixel != first.pixel);
    CHECK(pixels.contains({seen.x, seen.y}));
    state.structures = {"bvh_skip", "grid"};
    stage.show(state);
    CHECK(!after_key(state, stage, "l").pixel);
}
