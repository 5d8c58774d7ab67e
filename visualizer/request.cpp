#include "request.h"

#include "basics/error.h"
#include "basics/text.h"
#include "hard_cases/hard_cases.h"
#include "json_files.h"
#include "scene/camera_text.h"
#include "scene/ray_file.h"
#include "state_fields.h"
#include "structure/structure.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/replay/walk_recorder.h"
#include "walk_file.h"

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace raysteps::view {

namespace {

// The text of each option that was given.
using Given = std::map<std::string, std::string>;
using Names = std::vector<std::string>; // of structures

// read() is what a field's option means, for each type of field: the text becomes the new value.
// What the text leaves open stays as it was before.

struct Written {
    std::string option;
    std::string text;
};

[[noreturn]] void refuse(const Written& written, const std::string& what) {
    throw InputError(written.option + " " + written.text + ": " + what);
}

int whole_number(const Written& written, const std::string& text, int lowest) {
    const auto number = parse_number<int>(text);
    if (!number || *number < lowest) {
        refuse(written, "give a whole number from " + std::to_string(lowest) + " on.");
    }
    return *number;
}

std::string read(const Written& written, const std::string&) {
    return written.text;
}

bool read(const Written&, bool) {
    return true;
}

int read(const Written& written, int) {
    return whole_number(written, written.text, 0);
}

double read(const Written& written, double) {
    const auto number = parse_number<double>(written.text);
    if (!number || !(*number >= 0.0 && *number <= 1.0)) {
        refuse(written, "give a number from 0 to 1.");
    }
    return *number;
}

// CLI11 has already refused any other word.
template <class Choice>
requires std::is_enum_v<Choice> Choice read(const Written& written, Choice before) {
    const Words words = words_of(before);
    return static_cast<Choice>(std::find(words.begin(), words.end(), written.text) - words.begin());
}

glm::ivec2 read(const Written& written, const glm::ivec2&) {
    const PictureSize size = parse_size(written.text);
    return {size.width, size.height};
}

std::optional<glm::ivec2> read(const Written& written, const std::optional<glm::ivec2>&) {
    const std::vector<std::string> words = split_words(written.text, ',');
    const auto x = parse_number<int>(words.front());
    const auto y = parse_number<int>(words.back());
    if (words.size() != 2 || !x || !y) {
        refuse(written, "give a column and a row, as in 256,200; 0,0 is at the top left.");
    }
    return glm::ivec2(*x, *y);
}

std::optional<Camera> read(const Written& written, const std::optional<Camera>& before) {
    return parse_camera(written.text, before.value_or(Camera{}));
}

std::optional<Ray> read(const Written& written, const std::optional<Ray>&) {
    const std::vector<float> n = parse_numbers(written.text).value_or(std::vector<float>{});
    if (n.size() != 6 && n.size() != 8) {
        refuse(written, "give six numbers, the origin x,y,z and the direction x,y,z, or eight, "
                        "with t_min and t_max.");
    }
    Ray ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, 0.0f, std::numeric_limits<float>::max()};
    if (n.size() == 8) {
        ray.t_min = n[6];
        ray.t_max = n[7];
    }
    if (ray.direction == glm::vec3(0.0f)) {
        refuse(written, "the direction is 0,0,0. Give it a length.");
    }
    return ray;
}

std::optional<ClipPlane> read(const Written& written, const std::optional<ClipPlane>&) {
    const std::vector<float> n = parse_numbers(written.text).value_or(std::vector<float>{});
    if (n.size() != 6) {
        refuse(written, "give six numbers, a point x,y,z of the plane and its normal x,y,z.");
    }
    const glm::vec3 normal(n[3], n[4], n[5]);
    if (normal == glm::vec3(0.0f)) {
        refuse(written, "the normal is 0,0,0. Give it a length.");
    }
    return ClipPlane{{n[0], n[1], n[2]}, glm::normalize(normal)};
}

Levels read(const Written& written, const Levels&) {
    const std::vector<std::string> words = split_words(written.text, '-');
    if (words.size() > 2) {
        refuse(written, "give a level, as in 3, or two, as in 2-5.");
    }
    const Levels levels{whole_number(written, words.front(), 0),
                        whole_number(written, words.back(), 0)};
    if (levels.highest < levels.lowest) {
        refuse(written, "the first level is the lower one. Swap them.");
    }
    return levels;
}

Names read(const Written& written, const Names&) {
    return split_words(written.text, ',');
}

// Each builder option has its own name on the command line.
std::map<std::string, std::string> read(const Written&,
                                        const std::map<std::string, std::string>& before) {
    return before;
}

// The default of a field in --help; empty where there is none to show.
template <class Value>
std::string default_text(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        return word_of(value);
    } else {
        return "";
    }
}

std::string default_text(const std::string& value) {
    return value;
}

std::string default_text(const Names& names) {
    return names.front();
}

// Without --table there is no table.
std::string default_text(SortBy) {
    return "";
}

std::string default_text(int number) {
    return number > 0 ? std::to_string(number) : "";
}

std::string default_text(double number) {
    return short_number(number);
}

std::string default_text(const glm::ivec2& size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

template <class Value>
void add_option(CLI::App& app, const Field& field, const Value& initial, std::string& text) {
    if constexpr (std::is_same_v<Value, bool>) {
        app.add_flag(field.option, field.meaning);
        return;
    } else {
        CLI::Option& option = *app.add_option(field.option, text, field.meaning);
        option.type_name(std::is_same_v<Value, int>      ? "INT"
                         : std::is_same_v<Value, double> ? "FLOAT"
                                                         : "TEXT");
        option.default_str(default_text(initial));
        if constexpr (std::is_enum_v<Value>) {
            option.check(CLI::IsMember(words_of(initial)));
        }
        if constexpr (std::is_same_v<Value, Names>) {
            option.join(',');
        }
    }
}

void add_options(CLI::App& app, Given& given, Request& request) {
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    const State initial;
    visit_fields([&](const Field& field, auto member) {
        if (!field.option.empty()) {
            add_option(app, field, initial.*member, given[field.option]);
        }
    });
    app.add_option("--rays", given["--rays"],
                   "show a ray of this file (.f32 or .csv, docs/ray_files.md)");
    app.add_option("--ray-number", given["--ray-number"],
                   "which ray of --rays, from 0; the first by default");
    app.add_option("--walk", given["--walk"],
                   "the walk of --structure kd, bvh or grid: restart, skip, mailbox, ...");
    app.add_option("--step", given["--step"],
                   "the step to show, counted from 1; last (the default); or parting, the step "
                   "at which two walks part");
    app.add_option("--find", request.sought,
                   "mark a cell: by its number, the one that lists a triangle as in t17, or the "
                   "smallest one around a point x,y,z");
    app.add_flag("--fly", request.fly, "look from close by at the step, at --select or at --why");
    app.add_option("--state", given["--state"], "start from a saved state");
    app.add_option("--save-state", request.save_to, "write the state to this file (.json)");
    app.add_option("--screenshot", request.screenshot,
                   "write a picture instead of opening a window");
    app.add_option("--animate", request.animation, "write a picture of each step to this folder");
    app.add_option("--export", request.exports,
                   "write .vtp, .vtm, .gltf, .vtkjs or .json; several between commas")
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    for (const auto& [name, option] : all_build_options()) {
        app.add_option("--" + name, request.state.build_values[name], option.meaning);
    }
}

// Every option has a place for its text; this keeps only those that were given.
void forget_others(const CLI::App& app, Given& texts, const std::string& dashes) {
    std::erase_if(texts, [&](const auto& text) { return app.count(dashes + text.first) == 0; });
}

// `--structure kd --walk ropes` is kd_ropes.
std::string structure_with_walk(const Names& structures, const std::string& walk) {
    if (structures.size() > 1) {
        throw InputError("--walk " + walk +
                         ": it goes with one --structure. Name walks in full instead, as in "
                         "--structure kd_restart,kd_ropes.");
    }
    const std::string family =
        structures.empty() ? "" : family_of(split_words(structures.front(), ':').front()).name;
    std::string names;
    for (const std::string& name : recorded_structures()) {
        if (name == walk || name == family + "_" + walk) {
            return name;
        }
        if (name.starts_with(family)) {
            names += (names.empty() ? "" : ", ") + name;
        }
    }
    throw InputError("--walk " + walk + ": there is no such walk. Take one of " + names + ".");
}

void refuse_contradictions(const Given& given) {
    if (given.contains("--hard-case") && given.contains("SCENE")) {
        throw InputError("--hard-case " + given.at("--hard-case") + " and the scene " +
                         given.at("SCENE") + " both say what to show. Leave one out.");
    }
    for (const std::string other : {"--pixel", "--ray", "--rays", "--hard-case"}) {
        if (given.contains("--steps") && given.contains(other)) {
            throw InputError("--steps and " + other + " both name the ray. Leave one out.");
        }
    }
    if (given.contains("--pixel") + given.contains("--ray") + given.contains("--rays") > 1) {
        throw InputError("--pixel, --ray and --rays all name the ray. Leave all but one out.");
    }
    if (given.contains("--ray-number") && !given.contains("--rays")) {
        throw InputError("--ray-number " + given.at("--ray-number") +
                         ": it is a ray of a file. Name the file with --rays.");
    }
}

Ray ray_of_file(const Given& given) {
    const std::vector<Ray> rays = read_ray_file(given.at("--rays"));
    const auto text = given.find("--ray-number");
    const int number =
        text == given.end() ? 0 : whole_number({text->first, text->second}, text->second, 0);
    if (static_cast<std::size_t>(number) >= rays.size()) {
        throw InputError("--ray-number " + std::to_string(number) + ": " + given.at("--rays") +
                         " has " + std::to_string(rays.size()) + " rays, counted from 0.");
    }
    return rays[static_cast<std::size_t>(number)];
}

bool has_grids_only(const State& state) {
    return std::all_of(state.structures.begin(), state.structures.end(),
                       [](const std::string& name) { return name.starts_with("grid"); });
}

// --camera with a word instead of numbers.
State with_camera_word(State state, Given& given) {
    const auto camera = given.find("--camera");
    if (camera == given.end()) {
        return state;
    }
    const std::optional<CameraChoice> choice = camera_choice(camera->second);
    state.placed = choice.value_or(CameraChoice::automatic);
    if (choice) {
        state.camera.reset();
        given.erase(camera);
    }
    return state;
}

State with_options(State state, const Given& given) {
    if (given.contains("--viewpoint")) {
        state.viewpoint.reset(); // a new one is upright, however the saved one was turned
    }
    visit_fields([&](const Field& field, auto member) {
        if (const auto option = given.find(field.option); option != given.end()) {
            state.*member = read({field.option, option->second}, state.*member);
        }
    });
    if (given.contains("--walk")) {
        const bool named = given.contains("--structure");
        state.structures = {
            structure_with_walk(named ? state.structures : Names{}, given.at("--walk"))};
    }
    if (given.contains("SCENE")) {
        state.hard_case.clear();
    }
    if (given.contains("--hard-case")) {
        state.hard_case = find_hard_case(state.hard_case).name;
    }
    if (given.contains("--pixel")) {
        state.ray.reset();
    }
    if (given.contains("--rays")) {
        state.ray = ray_of_file(given);
    }
    if (given.contains("--ray") || given.contains("--rays")) {
        state.pixel.reset();
    }
    const bool new_ray = given.contains("--pixel") || given.contains("--ray") ||
                         given.contains("--rays") || given.contains("--hard-case");
    if (new_ray && !given.contains("--show")) {
        state.filter = CellFilter::visited;
    }
    const bool new_structures = given.contains("--structure") || given.contains("--walk");
    if (new_structures && has_grids_only(state) && !given.contains("--color")) {
        state.color = CellColor::triangles; // all cells have one depth
    }
    if (given.contains("--table")) {
        state.table = true;
        state.descending = state.sort_by != SortBy::id && state.sort_by != SortBy::depth;
    }
    if (given.contains("--window-size") && (state.window.x < 320 || state.window.y < 240)) {
        refuse({"--window-size", given.at("--window-size")},
               "too small to read anything. Take 320x240 at least.");
    }
    return state;
}

// What the file says of its walk, and the command line does not.
void take_told_walk(State& state, const Given& given) {
    const ToldWalk told = read_told_walk(state.steps);
    state.pixel.reset();
    state.ray.reset();
    if (!given.contains("SCENE") && !told.scene.empty()) {
        state.scene = told.scene;
    }
    if (!given.contains("--structure") && !given.contains("--walk") && is_walk_of_ours(told)) {
        state.structures = {told.structure};
    }
    if (!given.contains("--show")) {
        state.filter = CellFilter::visited;
    }
}

void take_step(Request& request, const std::string& text) {
    if (text == "parting") {
        request.to_parting = true;
    } else if (text == "last") {
        request.state.step = last_step;
    } else {
        request.state.step = whole_number({"--step", text}, text, 1) - 1;
    }
}

} // namespace

Request read_request(int argc, char** argv) {
    CLI::App app("Shows the cells of a structure and, step by step, how a ray walks through them.");
    Given given;
    Request request;
    add_options(app, given, request);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        request.help = app.help();
        return request;
    } catch (const CLI::ParseError& error) {
        throw InputError(std::string(error.what()) + ". See --help for the options.");
    }
    forget_others(app, given, "");
    forget_others(app, request.state.build_values, "--");
    refuse_contradictions(given);
    if (given.contains("--state")) {
        std::map<std::string, std::string> values = std::move(request.state.build_values);
        request.state = read_state(given["--state"]);
        values.merge(request.state.build_values); // those of the command line come first
        request.state.build_values = std::move(values);
    }
    request.state = with_camera_word(std::move(request.state), given);
    request.state = with_options(std::move(request.state), given);
    if (given.contains("--steps")) {
        take_told_walk(request.state, given);
        request.to_parting = !given.contains("--step");
    }
    if (given.contains("--step")) {
        take_step(request, given["--step"]);
    }
    const std::size_t told = request.state.steps.empty() ? 0 : 1;
    if (request.to_parting && request.state.structures.size() + told < 2) {
        throw InputError("--step parting: it takes two walks to part. Name two structures, as in "
                         "--structure bvh_ordered,bvh_skip.");
    }
    return request;
}

} // namespace raysteps::view
