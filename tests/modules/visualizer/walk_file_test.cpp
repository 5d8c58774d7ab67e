#include "visualizer/walk_file.h"

#include "basics/error.h"
#include "catch.h"
#include "shown.h"
#include "support/scratch_folder.h"
#include "visualizer/read_told_walk.h"
#include "visualizer/replay/sentence.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace raysteps;
using namespace raysteps::view;

namespace {

nlohmann::json written(const Stage& stage, const State& state, const ScratchFolder& folder) {
    write_walk(folder / "walk.json", stage, state);
    std::ifstream file(folder / "walk.json");
    return nlohmann::json::parse(file);
}

} // namespace

TEST_CASE("a written walk has the model and each step with its sentence and box",
          "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file");
    for (const std::string structure : {"every_triangle", "grid", "kd_ropes", "bvh_ordered"}) {
        CAPTURE(structure);
        const State state = mirrors_state(structure);
        Stage stage;
        stage.show(state);
        const RecordedWalk& walk = *walk_in(*stage.panes().front(), state);
        const nlohmann::json file = written(stage, state, folder);
        CHECK(file["triangles"].size() == stage.scene().corners.size());
        CHECK(file["points"].size() < 3 * stage.scene().corners.size());
        REQUIRE(file["steps"].size() == walk.steps.size());
        std::size_t tests = 0;
        for (std::size_t i = 0; i < walk.steps.size(); ++i) {
            const nlohmann::json& step = file["steps"][i];
            CHECK(step["sentence"] == sentence_of(stage.panes().front()->cells, walk, i));
            CHECK(step["box"].is_null() == (walk.steps[i].cell == no_cell));
            tests += step["tested"].size();
        }
        CHECK(tests == walk.tests.size());
        CHECK(file["ending"] == ending_of(walk));
    }
}

TEST_CASE("a written walk has the box of each part of the structure that lists a triangle",
          "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_boxes");
    for (const std::string structure : {"every_triangle", "grid", "kd_ropes", "bvh_ordered"}) {
        CAPTURE(structure);
        const State state = mirrors_state(structure);
        Stage stage;
        stage.show(state);
        const std::vector<Cell>& cells = stage.panes().front()->cells.cells;
        const auto listing = std::count_if(cells.begin(), cells.end(),
                                           [](const Cell& cell) { return cell.triangles > 0; });
        const nlohmann::json boxes = written(stage, state, folder)["boxes"];
        REQUIRE(boxes.size() == static_cast<std::size_t>(listing));
        CHECK(boxes.empty() == (structure == "every_triangle"));
        for (const nlohmann::json& box : boxes) {
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(box[0][axis].get<double>() <= box[1][axis].get<double>());
            }
        }
    }
}

TEST_CASE("a written ray that hits ends at its hit", "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_ray");
    State state = mirrors_state("grid");
    state.scene = "cornell_box";
    Stage stage;
    stage.show(state);
    const RecordedWalk& walk = *walk_in(*stage.panes().front(), state);
    REQUIRE(walk.hit.triangle != no_triangle);
    const nlohmann::json file = written(stage, state, folder);
    const glm::vec3 end = walk.ray.origin + walk.hit.t * walk.ray.direction;
    for (int axis = 0; axis < 3; ++axis) {
        // Six digits are written: half a unit of the sixth, of numbers under 1000, is 5e-4 at most.
        CHECK_THAT(file["line"][1][axis].get<double>(),
                   Catch::Matchers::WithinAbs(end[axis], 5e-4));
    }
}

TEST_CASE("a walk without a ray is not written", "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_none");
    State state = mirrors_state("grid");
    state.pixel.reset();
    Stage stage;
    stage.show(state);
    CHECK_THROWS_AS(write_walk(folder / "walk.json", stage, state), InputError);
}

TEST_CASE("a walk that cannot be written is an error", "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_place");
    const State state = mirrors_state("grid");
    Stage stage;
    stage.show(state);
    CHECK_THROWS_AS(write_walk("/dev/null", stage, state), InputError);
}

TEST_CASE("a written walk that is read is shown beside ours and never parts from it",
          "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_read");
    for (const std::string structure : {"every_triangle", "grid", "kd_ropes", "bvh_skip", "bvh4"}) {
        CAPTURE(structure);
        State state = mirrors_state(structure);
        Stage stage;
        stage.show(state);
        const RecordedWalk walk = *walk_in(*stage.panes().front(), state);
        write_walk(folder / "walk.json", stage, state);
        state.pixel.reset();
        state.steps = folder / "walk.json";
        stage.show(state);
        REQUIRE(stage.panes().size() == 2);
        const RecordedWalk& told = *walk_in(*stage.panes().front(), state);
        CHECK(told.told_by == structure);
        CHECK(told.ray.direction == walk.ray.direction);
        CHECK(told.steps.size() == walk.steps.size());
        CHECK(told.hit.t == walk.hit.t);
        CHECK(!parting_of(stage, state));
        state.steps.clear();
        stage.show(state);
        CHECK(stage.panes().size() == 1);
    }
}

TEST_CASE("a file that is no walk is refused by its name", "[visualizer][walk_file]") {
    const ScratchFolder folder("visualizer_walk_file_none_read");
    std::ofstream(folder / "walk.json") << R"({"schema": "walk.schema.json", "schema_version": 2})";
    CHECK_THROWS_WITH(read_told_walk(folder / "walk.json"),
                      contains_text("walk.json: is no file of recorded steps"));
    CHECK_THROWS_AS(read_told_walk(folder / "nothing.json"), InputError);
}
