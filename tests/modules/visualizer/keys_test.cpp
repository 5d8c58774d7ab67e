#include "catch.h"
#include "shown.h"
#include "visualizer/cell_choice.h"
#include "visualizer/keys.h"
#include "visualizer/layout.h"
#include "visualizer/pointing.h"

#include <algorithm>
#include <set>

using namespace raysteps;
using namespace raysteps::view;

namespace {

glm::ivec2 middle_of(const Area& area) {
    return {area.x + area.width / 2, area.y + area.height / 2};
}

} // namespace

TEST_CASE("keys step through the walk and stop at its ends", "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const int steps = step_count(stage, state);
    REQUIRE(steps > 5);
    state = after_key(state, stage, "Home");
    CHECK(state.step == 0);
    CHECK(after_key(state, stage, "p").step == 0);
    CHECK(after_key(after_key(state, stage, "n"), stage, "Right").step == 2);
    CHECK(after_key(after_key(state, stage, "n"), stage, "Left").step == 0);
    state = after_key(state, stage, "End");
    CHECK(step_in(*walk_in(*stage.panes().front(), state), state) ==
          static_cast<std::size_t>(steps - 1));
    CHECK(after_key(state, stage, "n").step == steps - 1);
    CHECK(after_key(state, stage, "p").step == steps - 2);
}

TEST_CASE("tab goes through the rays behind the pixel and round", "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const std::size_t rays = stage.panes().front()->path.size();
    REQUIRE(rays > 1);
    for (std::size_t i = 1; i < rays; ++i) {
        state = after_key(state, stage, "Tab");
        CHECK(state.path_ray == static_cast<int>(i));
        CHECK(walk_in(*stage.panes().front(), state) == &stage.panes().front()->path[i].walk);
    }
    CHECK(after_key(state, stage, "Tab").path_ray == 0);
}

TEST_CASE("the key D jumps to where two walks part", "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state();
    state.structures = {"kd_restart", "kd_backtrack"};
    stage.show(state);
    const auto parting = parting_of(stage, state);
    REQUIRE(parting);
    CHECK(after_key(state, stage, "d").step == static_cast<int>(parting->first_step));
    state.structures = {"grid", "kd_ropes"};
    stage.show(state);
    const auto apart = parting_of(stage, state);
    REQUIRE(apart);
    REQUIRE(apart->first_step != apart->second_step);
    const State one = after_key(state, stage, "d");
    const State other = after_key(one, stage, "d");
    CHECK(std::set<int>{one.step, other.step} ==
          std::set<int>{static_cast<int>(apart->first_step), static_cast<int>(apart->second_step)});
    CHECK(after_key(other, stage, "d").step == one.step);
    state.structures = {"kd_restart", "kd_restart"};
    stage.show(state);
    CHECK(!parting_of(stage, state));
    CHECK(after_key(state, stage, "d").step == state.step);
}

TEST_CASE("a cell that is marked is seen in the table", "[visualizer][table]") {
    Stage stage;
    State state = mirrors_state();
    state.table = true;
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    const std::vector<int> order = sorted_cells(pane, state);
    const int rows = table_rows(layout_of(state, 1));
    for (const std::size_t place : {std::size_t{0}, order.size() / 2, order.size() - 1}) {
        const State next = with_selected(state, stage, order[place]);
        CHECK(next.selected == order[place]);
        CHECK(next.first_row <= static_cast<int>(place));
        CHECK(static_cast<int>(place) < next.first_row + rows);
    }
    CHECK(with_selected(state, stage, no_cell).first_row == state.first_row);
}

TEST_CASE("a marked row stays in sight in every order", "[visualizer][table]") {
    Stage stage;
    State state = mirrors_state();
    state.table = true;
    stage.show(state);
    state.selected = sorted_cells(*stage.panes().front(), state).back();
    for (int order = 0; order < 5; ++order) {
        state = after_key(state, stage, "j");
        const std::vector<int> cells = sorted_cells(*stage.panes().front(), state);
        const auto row = std::find(cells.begin(), cells.end(), state.selected) - cells.begin();
        CAPTURE(order, row, state.first_row);
        CHECK(row >= state.first_row);
        CHECK(row < state.first_row + table_rows(layout_of(state, 1)));
    }
}

TEST_CASE("control with a letter is another key than the letter", "[visualizer][keys]") {
    Stage stage;
    const State state = mirrors_state();
    stage.show(state);
    CHECK(changes_state("z"));
    CHECK_FALSE(changes_state("Control+z"));
    CHECK_FALSE(changes_state("Shift_L"));
    CHECK(window_action("Control+z") == WindowAction::undo);
    CHECK(window_action("Control+y") == WindowAction::redo);
    CHECK_FALSE(after_key(state, stage, "Control+x").clip);
}

TEST_CASE("keys turn what is drawn", "[visualizer][keys]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    CHECK(after_key(state, stage, "w").model == ModelStyle::wireframe);
    CHECK(after_key(state, stage, "s").model == ModelStyle::solid);
    CHECK(after_key(state, stage, "v").filter == CellFilter::tested);
    CHECK(after_key(state, stage, "c").color == CellColor::triangles);
    CHECK(after_key(state, stage, "i").heat_map == HeatMap::visits);
    CHECK(after_key(state, stage, "plus").opacity == Approx(state.opacity + 0.05));
    State clipped = after_key(state, stage, "y");
    REQUIRE(clipped.clip);
    CHECK(clipped.clip->normal == glm::vec3(0, 1, 0));
    clipped = after_key(clipped, stage, "y");
    CHECK(clipped.clip->normal == glm::vec3(0, -1, 0));
    CHECK(!after_key(clipped, stage, "y").clip);
    const State fewer = after_key(state, stage, "bracketleft");
    CHECK(levels_of(*stage.panes().front(), fewer).highest ==
          stage.panes().front()->cells.deepest - 1);
    CHECK(after_key(state, stage, "F7").step == state.step);
    state.viewpoint = stage.camera();
    CHECK(after_key(state, stage, "f").viewpoint->eye != state.viewpoint->eye);
    CHECK(!after_key(state, stage, "r").viewpoint);
    CHECK(window_action("q") == WindowAction::quit);
    CHECK(window_action("space") == WindowAction::play);
    CHECK(window_action("n") == WindowAction::none);
}

TEST_CASE("the help sheet shows the current values", "[visualizer][keys]") {
    State state = mirrors_state();
    CHECK_THAT(help_text(state), contains_text("now visited") && contains_text("now last"));
    state.filter = CellFilter::all;
    state.step = 6;
    CHECK_THAT(help_text(state), contains_text("now all") && contains_text("now 7"));
}

TEST_CASE("a click on a slider sets its value", "[visualizer][mouse]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const view::Layout layout = layout_of(state, 1);
    const int steps = step_count(stage, state);
    CHECK(after_click(state, stage, middle_of(layout.step_slider)).step == steps / 2);
    CHECK(after_click(state, stage, middle_of(layout.opacity_slider)).opacity ==
          Approx(0.5).margin(0.01));
    const glm::ivec2 left{layout.level_slider.x + 1, layout.level_slider.y + 2};
    const State root = after_click(state, stage, {left.x + layout.level_slider.width - 3, left.y});
    CHECK(root.levels.highest == stage.panes().front()->cells.deepest);
    const State lower = after_click(state, stage, middle_of(layout.level_slider));
    CHECK(lower.levels.highest == (stage.panes().front()->cells.deepest + 1) / 2);
    CHECK(is_on_panel(state, stage, middle_of(layout.step_slider)));
    CHECK(!is_on_panel(state, stage, middle_of(layout.panes.front())));
}

TEST_CASE("a click on a heat map takes that pixel's ray", "[visualizer][mouse]") {
    Stage stage;
    State state = mirrors_state();
    state.heat_map = HeatMap::visits;
    stage.show(state);
    const Area picture = picture_area(layout_of(state, 1).heat_maps.front(), state.picture);
    const State middle = after_click(state, stage, middle_of(picture));
    REQUIRE(middle.pixel);
    CHECK(std::abs(middle.pixel->x - 32) <= 1);
    CHECK(std::abs(middle.pixel->y - 32) <= 1);
    const State corner = after_click(state, stage, {picture.x, picture.y + picture.height - 1});
    CHECK(*corner.pixel == glm::ivec2(0, 0));
}

TEST_CASE("a table is sorted and its rows selected by clicks and keys", "[visualizer][mouse]") {
    Stage stage;
    State state = mirrors_state();
    state.table = true;
    stage.show(state);
    const Area table = layout_of(state, 1).table;
    REQUIRE(table.height > 5 * row_height);
    const int head = table.y + table.height - row_height / 2;
    const State by_id = after_click(state, stage, {table.x + margin + 5, head});
    CHECK(by_id.sort_by == SortBy::id);
    const State turned = after_click(by_id, stage, {table.x + margin + 5, head});
    CHECK(turned.descending != by_id.descending);
    const std::vector<int> order = sorted_cells(*stage.panes().front(), state);
    const State third = after_click(state, stage, {table.x + 50, head - 3 * row_height});
    CHECK(third.selected == order[2]);
    CHECK(after_key(third, stage, "Down").selected == order[3]);
    CHECK(after_key(third, stage, "Up").selected == order[1]);
}

TEST_CASE("a click in space finds the model and the smallest cell under it",
          "[visualizer][mouse]") {
    Stage stage;
    State state = mirrors_state();
    state.window = {800, 600};
    stage.show(state);
    const Area pane = layout_of(state, 1).panes.front();
    const Camera viewpoint = stage.camera();
    // From the camera itself, every point of the middle shows what the picture shows.
    const auto point = point_under(state, stage, viewpoint, middle_of(pane));
    REQUIRE(point);
    const State picked = with_ray_to(state, stage, *point);
    REQUIRE(picked.ray);
    CHECK(!picked.pixel);
    stage.show(picked);
    const RecordedWalk& walk = *walk_in(*stage.panes().front(), picked);
    // The ray goes from the camera to the point, where t is 1 up to the rounding of the two rays:
    // the point is rounded to 2^-24 of its coordinates, under 16 here, at over 1 from the camera.
    CHECK(static_cast<double>(walk.hit.t) == Approx(1.0).margin(1e-5));
    State all = state;
    all.filter = CellFilter::occupied;
    all.levels.highest = 3;
    const int cell = cell_under(all, stage, viewpoint, middle_of(pane));
    REQUIRE(cell != no_cell);
    CHECK(stage.panes().front()->cells.cells[static_cast<std::size_t>(cell)].depth <= 3);
    CHECK(cell_under(all, stage, viewpoint, {pane.x + pane.width + 5, pane.y}) == no_cell);
}

TEST_CASE("a click from a viewpoint far away finds what the loop finds in every structure",
          "[visualizer][mouse]") {
    Stage by_loop;
    Stage by_tree;
    State looped = mirrors_state("every_triangle");
    State walked = mirrors_state("kd_ropes");
    looped.window = walked.window = {800, 600};
    by_loop.show(looped);
    by_tree.show(walked);
    Camera viewpoint = by_loop.camera();
    const float times = 1e5f;
    viewpoint.eye = viewpoint.target + times * (viewpoint.eye - viewpoint.target);
    viewpoint.vertical_field_of_view /= times;
    const Area pane = layout_of(looped, 1).panes.front();
    int found = 0;
    for (int x = pane.x; x < pane.x + pane.width; x += 20) {
        for (int y = pane.y; y < pane.y + pane.height; y += 20) {
            const auto expected = point_under(looped, by_loop, viewpoint, {x, y});
            CAPTURE(x, y);
            CHECK(point_under(walked, by_tree, viewpoint, {x, y}) == expected);
            found += expected ? 1 : 0;
        }
    }
    CHECK(found > 100);
}
