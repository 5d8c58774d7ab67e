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
