#include "visualizer/request.h"

#include "basics/error.h"
#include "catch.h"
#include "scene/ray_file.h"
#include "shown.h"
#include "support/scratch_folder.h"
#include "visualizer/json_files.h"

using namespace raysteps;
using namespace raysteps::view;

namespace {

Request request_of(std::vector<std::string> words) {
    words.insert(words.begin(), "visualizer");
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    return read_request(static_cast<int>(arguments.size()), arguments.data());
}

std::string sentence_of(const std::vector<std::string>& words) {
    try {
        request_of(words);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a ray of a file is shown by its number", "[visualizer][request]") {
    const ScratchFolder folder("view_rays");
    const std::vector<Ray> rays{{{1, 2, 3}, {0, 0, 1}, 0.0f, 9.0f},
                                {{4, 5, 6}, {1, 0, 0}, 0.5f, 7.0f}};
    const std::string file = (folder / "bad.csv").string();
    write_ray_file(file, rays);
    CHECK(request_of({"--rays", file}).state.ray->origin == rays[0].origin);
    const State state = request_of({"--rays", file, "--ray-number", "1"}).state;
    CHECK(state.ray->origin == rays[1].origin);
    CHECK(state.ray->t_min == 0.5f);
    CHECK(!state.pixel);
    CHECK(state.filter == CellFilter::visited);
    CHECK_THAT(sentence_of({"--rays", file, "--ray-number", "2"}), contains_text("has 2 rays"));
    CHECK_THAT(sentence_of({"--ray-number", "1"}), contains_text("Name the file with --rays"));
    CHECK_THAT(sentence_of({"--rays", file, "--pixel", "1,1"}), contains_text("all but one"));
}

TEST_CASE("options become a state", "[visualizer][request]") {
    const Request request = request_of(
        {"mirrors", "--structure", "grid,kd_ropes", "--pixel", "3,4",     "--size",       "64x32",
         "--step",  "7",           "--levels",      "2-5",     "--color", "cost",         "--split",
         "median",  "--clip",      "0,1,2,0,0,4",   "--table", "depth",   "--screenshot", "a.png"});
    const State& state = request.state;
    CHECK(state.scene == "mirrors");
    CHECK(state.structures == std::vector<std::string>{"grid", "kd_ropes"});
    CHECK(*state.pixel == glm::ivec2(3, 4));
    CHECK(state.picture == glm::ivec2(64, 32));
    CHECK(state.step == 6);
    CHECK(state.levels.lowest == 2);
    CHECK(state.levels.highest == 5);
    CHECK(state.color == CellColor::cost);
    CHECK(state.filter == CellFilter::visited);
    CHECK(state.build_values.at("split") == "median");
    CHECK(state.clip->normal == glm::vec3(0, 0, 1));
    CHECK(state.table);
    CHECK(state.sort_by == SortBy::depth);
    CHECK(request.screenshot == "a.png");
    CHECK(request_of({"--structure", "kd", "--walk", "restart"}).state.structures.front() ==
          "kd_restart");
    CHECK(request_of({"--structure", "grid,kd_ropes", "--step", "parting"}).to_parting);
    CHECK_THROWS_WITH(request_of({"--step", "parting"}), contains_text("--step parting"));
    CHECK(!request_of({"--help"}).help.empty());
}

TEST_CASE("a ray of eight numbers has a range", "[visualizer][request]") {
    const Ray ray = *request_of({"--ray", "1,2,3,0,0,1,0.5,4"}).state.ray;
    CHECK(ray.origin == glm::vec3(1, 2, 3));
    CHECK(ray.t_min == 0.5f);
    CHECK(ray.t_max == 4.0f);
    CHECK(request_of({"--ray", "1,2,3,0,0,1"}).state.ray->t_min == 0.0f);
}

TEST_CASE("options that make no sense are named in a sentence", "[visualizer][request]") {
    CHECK_THAT(sentence_of({"--pixel", "3"}), contains_text("--pixel 3"));
    CHECK_THAT(sentence_of({"--ray", "0,0,0,0,0,0"}), contains_text("--ray"));
    CHECK_THAT(sentence_of({"--ray", "1,2,3"}), contains_text("six numbers"));
    CHECK_THAT(sentence_of({"--ray", "0,0,0,1,0,0,0"}), contains_text("or eight"));
    CHECK_THAT(sentence_of({"--pixel", "1,1", "--ray", "0,0,0,1,0,0"}),
               contains_text("all but one"));
    CHECK_THAT(sentence_of({"--step", "0"}), contains_text("--step 0"));
    CHECK_THAT(sentence_of({"--levels", "5-2"}), contains_text("--levels 5-2"));
    CHECK_THAT(sentence_of({"--color", "mood"}),
               contains_text("--color") && contains_text("visits"));
    CHECK_THAT(sentence_of({"--bounces", "-2"}), contains_text("--bounces -2"));
    CHECK_THAT(sentence_of({"--opacity", "2"}), contains_text("from 0 to 1"));
    CHECK_THAT(sentence_of({"--walk", "crawl", "--structure", "kd"}), contains_text("kd_ropes"));
    CHECK_THAT(sentence_of({"--window-size", "10x10"}), contains_text("320x240"));
    CHECK_THAT(sentence_of({"--hard-case", "Q9"}), contains_text("Q9"));
    CHECK_THAT(sentence_of({"bunny", "--hard-case", "K3"}), contains_text("bunny"));
    CHECK_THAT(sentence_of({"--no-such-option"}), contains_text("--no-such-option"));
    CHECK_THAT(sentence_of({"--state", "no_such_file.json"}), contains_text("no_such_file.json"));
}

TEST_CASE("a saved state is the same state again", "[visualizer][state]") {
    const ScratchFolder folder("visualizer_state");
    State state = mirrors_state("grid");
    state.ray = Ray{{0.1f, -2.5e-8f, 3.0f}, {1.0f / 3.0f, 7.0f, -0.0f}, 0.25f, 1e30f};
    state.pixel.reset();
    state.camera = Camera{{1, 2, 3.3f}, {4, 5, 6}, {0, 0, 1}, 33.3f};
    state.viewpoint = state.camera;
    state.clip = ClipPlane{{1, 2, 3}, {0, 1, 0}};
    state.build_values["density"] = "2";
    state.hard_ray = 5;
    state.step = 4;
    state.table = true;
    state.sort_by = SortBy::area;
    state.heat_map = HeatMap::tests;
    save_state(folder / "a.json", state);
    CHECK(state_text(read_state(folder / "a.json")) == state_text(state));
    const Ray read = *read_state(folder / "a.json").ray;
    CHECK(read.direction == state.ray->direction);
    CHECK(read.origin == state.ray->origin);
    const Request request = request_of({"--state", (folder / "a.json").string(), "--step", "9"});
    CHECK(request.state.step == 8);
    CHECK(request.state.sort_by == SortBy::area);
    CHECK(request.state.color == state.color);
}

TEST_CASE("a state that was saved by an earlier version opens", "[visualizer][state]") {
    const State state = parse_state(R"({
        "scene": "mirrors", "hard_case": "", "hard_ray": -1, "structures": ["kd_ropes"],
        "build_values": {"split": "median"},
        "camera": {"eye": [1.0, 2.0, 3.0], "target": [0.0, 0.0, 0.0], "up": [0.0, 1.0, 0.0],
                   "vertical_field_of_view": 35.0},
        "picture": [64, 32],
        "ray": {"origin": [0.0, 0.0, 5.0], "direction": [0.0, 0.0, -1.0], "t_min": 0.0,
                "t_max": 9.0},
        "bounces": 2, "path_ray": 1, "step": 3, "model": "solid", "show": "all",
        "color": "visits", "levels": [1, -1], "opacity": 0.25, "most_cells": 7,
        "clip": {"point": [1.0, 2.0, 3.0], "normal": [0.0, 1.0, 0.0]}, "heat_map": "tests",
        "table": true, "sort_by": "area", "descending": false, "first_row": 2, "selected": 5,
        "help": true, "window": [900, 640]})",
                                    "old.json");
    CHECK(state.build_values.at("split") == "median");
    CHECK(state.camera->vertical_field_of_view == 35.0f);
    CHECK(state.picture == glm::ivec2(64, 32));
    CHECK(state.ray->t_max == 9.0f);
    CHECK(state.step == 3);
    CHECK(state.model == ModelStyle::solid);
    CHECK(state.levels.lowest == 1);
    CHECK(state.levels.highest == all_levels);
    CHECK(state.clip->normal == glm::vec3(0, 1, 0));
    CHECK(!state.descending);
    CHECK(state.selected == 5);
    CHECK(!state.viewpoint);
}

TEST_CASE("a file that is no state says what is wrong with it", "[visualizer][state]") {
    const auto sentence = [](const std::string& text) {
        try {
            parse_state(text, "a.json");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(sentence("{"), contains_text("a.json"));
    CHECK_THAT(sentence("[]"), contains_text("structures"));
    CHECK_THAT(sentence(R"({"structures": ["grid"], "color": "mood"})"), contains_text("color"));
    CHECK_THAT(sentence(R"({"structures": ["grid"], "pixel": [1]})"), contains_text("pixel"));
    CHECK_THAT(sentence(R"({"structures": ["grid"], "window": [0, 9]})"), contains_text("window"));
    CHECK(sentence(R"({"structures": ["grid"]})").empty());
}
