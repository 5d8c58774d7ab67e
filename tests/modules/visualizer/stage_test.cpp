#include "basics/error.h"
#include "catch.h"
#include "shown.h"
#include "visualizer/cell_choice.h"
#include "visualizer/color_scale.h"
#include "visualizer/framing.h"
#include "visualizer/layout.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace raysteps;
using namespace raysteps::view;

TEST_CASE("a stage shows each structure with the walks of the same ray", "[visualizer][stage]") {
    State state = mirrors_state();
    state.structures = {"grid", "kd_ropes", "bvh_ordered:split=median"};
    Stage stage;
    stage.show(state);
    REQUIRE(stage.panes().size() == 3);
    REQUIRE(stage.ray());
    const int hit = walk_in(*stage.panes()[0], state)->hit.triangle;
    CHECK(hit != no_triangle);
    for (const auto& pane : stage.panes()) {
        CHECK(walk_in(*pane, state)->hit.triangle == hit);
        CHECK(pane->path.size() == stage.panes()[0]->path.size());
    }
    CHECK(stage.panes()[2]->structure == "bvh_ordered");
    CHECK(stage.panes()[2]->label == "bvh_ordered:split=median");
}

TEST_CASE("a stage builds anew only what has changed", "[visualizer][stage]") {
    std::vector<std::string> said;
    Stage stage([&](const std::string& what) { said.push_back(what); });
    State state = mirrors_state();
    stage.show(state);
    CHECK(said == std::vector<std::string>{"loading mirrors", "building bvh_ordered"});
    said.clear();
    state.step = 3;
    state.pixel = glm::ivec2(10, 10);
    stage.show(state);
    CHECK(said.empty());
    state.heat_map = HeatMap::visits;
    stage.show(state);
    CHECK(said == std::vector<std::string>{"tracing every pixel through bvh_ordered"});
    said.clear();
    stage.show(state);
    CHECK(said.empty());
    state.structures = {"grid"};
    stage.show(state);
    CHECK(said == std::vector<std::string>{"building grid", "tracing every pixel through grid"});
}

TEST_CASE("the heat map has the counts of each pixel's own ray", "[visualizer][stage]") {
    State state = mirrors_state("kd_short_stack");
    state.heat_map = HeatMap::tests;
    Stage stage;
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    REQUIRE(pane.counted.size() == 64 * 64);
    const std::vector<float> tests = heat_values(pane, HeatMap::tests);
    const std::vector<float> visits = heat_values(pane, HeatMap::visits);
    for (const glm::ivec2 pixel : {glm::ivec2(25, 38), glm::ivec2(0, 0), glm::ivec2(63, 20)}) {
        state.pixel = pixel;
        stage.show(state);
        const RecordedWalk& walk = *walk_in(pane, state);
        const auto place = static_cast<std::size_t>(64 * pixel.y + pixel.x);
        CHECK(tests[place] == static_cast<float>(walk.tests.size()));
        CHECK(visits[place] == static_cast<float>(walk.steps.size()));
    }
}

TEST_CASE("a heat map's last colour is what 99 in 100 pixels stay below", "[visualizer][stage]") {
    std::vector<float> values(200, 0.0f);
    std::iota(values.begin(), values.begin() + 100, 1.0f); // and 100 pixels that cost nothing
    CHECK(heat_limit(values) == 99.0);
    CHECK(heat_limit({0.0f, 0.0f}) == 1.0);
    CHECK(histogram_of({0.0f, 1.0f, 2.5f, 9.0f}, 4.0, 4) == std::vector<std::size_t>{1, 1, 1, 1});
}

TEST_CASE("several heat maps share the scale of the one that does most", "[visualizer][stage]") {
    State state = mirrors_state();
    state.structures = {"grid", "bvh_ordered"};
    state.heat_map = HeatMap::tests;
    Stage stage;
    stage.show(state);
    const auto own = [&](std::size_t pane) {
        return heat_limit(heat_values(*stage.panes()[pane], state.heat_map));
    };
    REQUIRE(own(0) > own(1));
    CHECK(heat_range(stage, state, 0).upper == own(0));
    CHECK(heat_range(stage, state, 1).upper == own(0));
    state.own_scales = true;
    CHECK(heat_range(stage, state, 1).upper == own(1));
}

TEST_CASE("the colour of a cost is its logarithm, and the legend says the cost",
          "[visualizer][stage]") {
    State state = mirrors_state();
    state.structures = {"bvh_ordered"};
    state.color = CellColor::cost;
    state.filter = CellFilter::all;
    Stage stage;
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    const double root = pane.cells.cells.front().cost;
    const double value = color_values(pane, state, {0}).front();
    CHECK(value == Approx(std::log10(root)));
    CHECK(number_of(CellColor::cost, value) == Approx(root));
    CHECK(number_of(CellColor::depth, 3.0) == 3.0);
    CHECK(color_range(stage, state).upper >= value);
    CHECK(color_in({0.0, 1.0}, -5.0) == color_in({0.0, 1.0}, 0.0)); // cells without a surface
}

TEST_CASE("the cells shown of a walk are those that it came to and did not leave out",
          "[visualizer][cells]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    const RecordedWalk& walk = *walk_in(pane, state);
    for (int last = 0; last < static_cast<int>(walk.steps.size()); ++last) {
        state.step = last;
        std::set<int> expected;
        for (int i = 0; i <= last; ++i) {
            const Step& step = walk.steps[static_cast<std::size_t>(i)];
            if (!is_culled(step.outcome)) {
                expected.insert(step.cell);
            }
        }
        const std::vector<int> shown = choose_cells(pane, state).cells;
        CHECK(std::set<int>(shown.begin(), shown.end()) == expected);
        CHECK(shown.size() == expected.size());
    }
}

TEST_CASE("levels and filters choose cells and a limit says how many it left out",
          "[visualizer][cells]") {
    Stage stage;
    State state = mirrors_state("kd_restart");
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    const auto count = [&](auto wanted) {
        return static_cast<std::size_t>(
            std::count_if(pane.cells.cells.begin(), pane.cells.cells.end(), wanted));
    };
    state.filter = CellFilter::all;
    state.levels.lowest = state.levels.highest = 4;
    CHECK(choose_cells(pane, state).cells.size() ==
          count([](const Cell& cell) { return cell.depth == 4; }));
    state.filter = CellFilter::occupied;
    state.levels.lowest = 2;
    const std::size_t occupied = count(
        [](const Cell& cell) { return cell.depth >= 2 && cell.depth <= 4 && cell.triangles > 0; });
    CHECK(choose_cells(pane, state).cells.size() == occupied);
    state.most_cells = 5;
    CHECK(choose_cells(pane, state).cells.size() == 5);
    CHECK(choose_cells(pane, state).left_out == occupied - 5);
}

TEST_CASE("the table has every cell once in the order asked for", "[visualizer][cells]") {
    Stage stage;
    State state = mirrors_state();
    stage.show(state);
    const Pane& pane = *stage.panes().front();
    for (const SortBy sort_by :
         {SortBy::id, SortBy::depth, SortBy::count, SortBy::area, SortBy::cost}) {
        state.sort_by = sort_by;
        const std::vector<int> order = sorted_cells(pane, state);
        CHECK(std::set<int>(order.begin(), order.end()).size() == pane.cells.cells.size());
    }
    state.sort_by = SortBy::count;
    CHECK(sorted_cells(pane, state).front() == 0); // the root has them all
    state.descending = false;
    const Cell& least =
        pane.cells.cells[static_cast<std::size_t>(sorted_cells(pane, state).front())];
    CHECK(least.triangles == 1);
}

TEST_CASE("what a state asks for in vain is named in a sentence", "[visualizer][stage]") {
    Stage stage;
    const auto sentence_of = [&](const State& state) {
        try {
            stage.show(state);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(sentence_of(mirrors_state("octree")),
               contains_text("octree") && contains_text("kd_ropes"));
    State state = mirrors_state();
    state.scene = "no_such_scene";
    CHECK_THAT(sentence_of(state), contains_text("no_such_scene"));
    state = mirrors_state();
    state.pixel = glm::ivec2(64, 0);
    CHECK_THAT(sentence_of(state), contains_text("--pixel 64,0") && contains_text("63,63"));
    state = mirrors_state("bvh_ordered:spilt=median");
    CHECK_THAT(sentence_of(state), contains_text("spilt"));
    state = mirrors_state("bvh_ordered:median");
    CHECK_THAT(sentence_of(state), contains_text("NAME=VALUE"));
    state = mirrors_state("grid");
    state.build_values["bins"] = "8";
    CHECK_THAT(sentence_of(state), contains_text("--bins"));
    // The stage goes on with the next state.
    CHECK(sentence_of(mirrors_state()).empty());
    CHECK(stage.panes().size() == 1);
}

TEST_CASE("a view without a viewpoint holds all of the scene", "[visualizer][framing]") {
    for (const bool with_ray : {false, true}) {
        Stage stage;
        State state = mirrors_state();
        if (!with_ray) {
            state.pixel.reset();
        }
        stage.show(state);
        for (const double aspect_ratio : {0.4, 1.0, 2.6}) {
            CAPTURE(with_ray, aspect_ratio);
            const Camera camera = frame_stage(stage, aspect_ratio);
            const glm::dvec3 ahead =
                glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
            double most = 0.0;
            for (int i = 0; i < 8; ++i) {
                const Box& box = stage.bounds();
                const glm::dvec3 corner((i & 1) != 0 ? box.upper.x : box.lower.x,
                                        (i & 2) != 0 ? box.upper.y : box.lower.y,
                                        (i & 4) != 0 ? box.upper.z : box.lower.z);
                const glm::dvec3 sight = corner - glm::dvec3(camera.eye);
                const double depth = glm::dot(sight, ahead);
                REQUIRE(depth > 0.0);
                const double tangent = std::tan(glm::radians(15.0));
                const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(camera.up)));
                const double x = glm::dot(sight, right) / (depth * tangent * aspect_ratio);
                const double y = glm::dot(sight, glm::cross(right, ahead)) / (depth * tangent);
                most = std::max({most, std::abs(x), std::abs(y)});
            }
            CHECK(most < 1.0);
            CHECK(most > 0.7); // and it is as large as it fits
        }
    }
}

TEST_CASE("hard cases come with a ray that breaks a usual method", "[visualizer][hard_case]") {
    for (const auto& [name, structure, method] : {std::tuple{"G1", "grid", "first hit"},
                                                  {"K3", "kd_restart", "first hit"},
                                                  {"T1", "bvh_ordered", "Moeller"}}) {
        CAPTURE(name);
        State state;
        state.hard_case = name;
        state.structures = {structure};
        Stage stage;
        stage.show(state);
        REQUIRE(stage.ray());
        CHECK_THAT(stage.note(), contains_text(name) && contains_text(method));
        CHECK(has_note(state));
        state.hard_ray = 1'000'000'000;
        CHECK_THROWS_WITH(stage.show(state), contains_text("--hard-ray"));
    }
}
