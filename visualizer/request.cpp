#include "request.h"

#include "basics/error.h"
#include "hard_cases/hard_cases.h"
#include "scene/camera_text.h"
#include "basics/text.h"
#include "visualizer/replay/walk_recorder.h"
#include "structure/structure.h"
#include "option_values.h"
#include "state_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace raysteps::view {

namespace {

// Options as they were written.
struct Written {
    std::string scene;
    std::string hard_case;
    std::string state_file;
    std::vector<std::string> structures;
    std::string walk;
    std::string pixel;
    std::string ray;
    std::string step;
    std::string camera;
    std::string size;
    std::string viewpoint;
    std::string window;
    std::string model;
    std::string filter;
    std::string color;
    std::string levels;
    std::string clip;
    std::string heat_map;
    std::string table;
    double opacity = -1.0;
    int path_ray = -1;
    int bounces = -1;
    int most_cells = -1;
    int selected = -1;
    int hard_ray = -1;
    bool help_sheet = false;
};

// `--structure kd --walk ropes` is kd_ropes.
std::vector<std::string> structures_of(const Written& words) {
    std::vector<std::string> structures;
    for (const std::string& text : words.structures) {
        for (const std::string& name : split_words(text, ',')) {
            structures.push_back(name);
        }
    }
    if (words.walk.empty()) {
        return structures;
    }
    if (structures.size() > 1) {
        throw InputError("--walk " + words.walk +
                         ": it goes with one --structure. Name walks in full instead, as in "
                         "--structure kd_restart,kd_ropes.");
    }
    const std::string family =
        structures.empty() ? "" : family_of(split_words(structures.front(), ':').front()).name;
    const std::vector<std::string> known = recorded_structures();
    for (const std::string& name : {words.walk, family + "_" + words.walk}) {
        if (std::find(known.begin(), known.end(), name) != known.end()) {
            return {name};
        }
    }
    std::string names;
    for (const std::string& name : known) {
        if (family.empty() || name.starts_with(family)) {
            names += (names.empty() ? "" : ", ") + name;
        }
    }
    throw InputError("--walk " + words.walk + ": there is no such walk. Take one of " + names +
                     ".");
}

void add_options(CLI::App& app, Written& words, Request& request) {
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("SCENE", words.scene, "an .obj or .toml file, or a sample scene (bunny)");
    app.add_option("--hard-case", words.hard_case,
                   "instead of a scene: the hard case of that name, as in K3, with the ray that "
                   "breaks a usual method");
    app.add_option("--hard-ray", words.hard_ray, "another one of its rays, from 0");
    app.add_option("--structure", words.structures,
                   "what is shown; several, between commas, side by side; with options of its own "
                   "as in bvh_ordered:split=median (bvh_ordered)")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--walk", words.walk, "with --structure kd: restart, backtrack, ...");
    app.add_option("--pixel", words.pixel, "the ray of this pixel: column,row from the top left");
    app.add_option("--ray", words.ray, "this ray: ox,oy,oz,dx,dy,dz, and perhaps t_min,t_max");
    app.add_option("--bounces", words.bounces, "mirror rays behind a pixel, at most (4)");
    app.add_option("--path-ray", words.path_ray,
                   "which ray behind the pixel to step through; 0 is the camera's");
    app.add_option("--step", words.step,
                   "the step to show, from 1, or last, or parting: where two walks part (last)");
    app.add_option("--camera", words.camera, "of the picture, as in all chapters");
    app.add_option("--size", words.size, "of the picture in pixels (512x512)");
    app.add_option("--viewpoint", words.viewpoint, "from where to look, like --camera");
    app.add_option("--window-size", words.window, "in pixels (1280x800)");
    app.add_option("--model", words.model, list_of(model_words()));
    app.add_option("--show", words.filter, "cells: " + list_of(filter_words()));
    app.add_option("--color", words.color, "of cells, by " + list_of(color_words()));
    app.add_option("--levels", words.levels, "of the tree, as in 3 or 2-5");
    app.add_option("--opacity", words.opacity, "of the faces of cells, 0 to 1 (0.12)");
    app.add_option("--most-cells", words.most_cells, "to draw (20000)");
    app.add_option("--clip", words.clip, "a plane: a point x,y,z and a normal x,y,z");
    app.add_option("--heat-map", words.heat_map, "of the picture: " + list_of(heat_map_words()));
    app.add_option("--table", words.table, "of cells, sorted by " + list_of(sort_words()));
    app.add_option("--select", words.selected, "mark the cell of this number");
    app.add_flag("--help-sheet", words.help_sheet, "show the keys and their values");
    app.add_option("--state", words.state_file, "begin with a state that was saved");
    app.add_option("--save-state", request.save_to, "write the state to this file (.json)");
    app.add_option("--screenshot", request.screenshot, "write a picture, and open no window");
    app.add_option("--animate", request.animation, "write a picture of each step to this folder");
    app.add_option("--export", request.exports, "write .vtp, .vtm, .gltf, .vtkjs or .json")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    for (const auto& [name, option] : all_build_options()) {
        app.add_option_function<std::string>(
            "--" + name,
            [&request, key = name](const std::string& value) {
                request.state.build_values[key] = value;
            },
            option.meaning);
    }
}

void take_what_to_see(State& state, const Written& words) {
    if (!words.scene.empty()) {
        state.scene = words.scene;
        state.hard_case.clear();
    }
    if (!words.hard_case.empty()) {
        if (!words.scene.empty()) {
            throw InputError("--hard-case " + words.hard_case + " and the scene " + words.scene +
                             " both say what to show. Leave one out.");
        }
        state.hard_case = find_hard_case(words.hard_case).name;
    }
    if (words.hard_ray >= 0) {
        state.hard_ray = words.hard_ray;
    }
    if (!words.structures.empty() || !words.walk.empty()) {
        state.structures = structures_of(words);
    }
    if (!words.size.empty()) {
        const PictureSize size = parse_size(words.size);
        state.picture = {size.width, size.height};
    }
    if (!words.camera.empty()) {
        state.camera = parse_camera(words.camera, state.camera.value_or(Camera{}));
    }
    if (!words.pixel.empty() && !words.ray.empty()) {
        throw InputError("--pixel and --ray both name the ray. Leave one out.");
    }
    if (!words.pixel.empty()) {
        state.pixel = read_pixel(words.pixel);
        state.ray.reset();
    }
    if (!words.ray.empty()) {
        state.ray = read_ray(words.ray);
        state.pixel.reset();
    }
    if (words.bounces >= 0) {
        state.bounces = words.bounces;
    }
    if (words.path_ray >= 0) {
        state.path_ray = words.path_ray;
    }
}

bool has_grids_only(const State& state) {
    return std::all_of(state.structures.begin(), state.structures.end(),
                       [](const std::string& name) { return name.starts_with("grid"); });
}

void take_how_it_is_drawn(State& state, const Written& words) {
    const bool new_ray = !words.pixel.empty() || !words.ray.empty() || !words.hard_case.empty();
    if (!words.filter.empty()) {
        state.filter = choose("show", words.filter, filter_words());
    } else if (new_ray) {
        state.filter = CellFilter::visited;
    }
    if (!words.model.empty()) {
        state.model = choose("model", words.model, model_words());
    }
    if (!words.color.empty()) {
        state.color = choose("color", words.color, color_words());
    } else if (has_grids_only(state)) {
        state.color = CellColor::triangles; // all cells have one depth
    }
    if (!words.levels.empty()) {
        const Levels levels = read_levels(words.levels);
        state.lowest_level = levels.lowest;
        state.highest_level = levels.highest;
    }
    if (words.opacity >= 0.0) {
        state.opacity = std::min(words.opacity, 1.0);
    }
    if (words.most_cells >= 0) {
        state.most_cells = words.most_cells;
    }
    if (!words.clip.empty()) {
        state.clip = read_clip(words.clip);
    }
    if (!words.heat_map.empty()) {
        state.heat_map = choose("heat-map", words.heat_map, heat_map_words());
    }
    if (!words.table.empty()) {
        state.sort_by = choose("table", words.table, sort_words());
        state.table = true;
        state.descending = state.sort_by != SortBy::id && state.sort_by != SortBy::depth;
    }
    if (words.selected >= 0) {
        state.selected = words.selected;
    }
    state.help = state.help || words.help_sheet;
    if (!words.viewpoint.empty()) {
        state.viewpoint = parse_camera(words.viewpoint, Camera{});
    }
    if (!words.window.empty()) {
        const PictureSize size = parse_size(words.window);
        if (size.width < 320 || size.height < 240) {
            throw InputError("--window-size " + words.window +
                             ": nothing could be read there. Take 320x240 at least.");
        }
        state.window = {size.width, size.height};
    }
}

void take_step(Request& request, const std::string& text) {
    if (text == "parting") {
        request.to_parting = true;
    } else if (text == "last") {
        request.state.step = last_step;
    } else if (!text.empty()) {
        request.state.step = whole_number("step", text, 1) - 1;
    }
}

} // namespace

Request read_request(int argc, char** argv) {
    CLI::App app("Shows the cells of a structure and, step by step, how a ray walks through them.");
    Written words;
    Request request;
    add_options(app, words, request);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        request.help = app.help();
        return request;
    } catch (const CLI::ParseError& error) {
        throw InputError(std::string(error.what()) + ". See --help for the options.");
    }
    if (!words.state_file.empty()) {
        const std::map<std::string, std::string> values = request.state.build_values;
        request.state = read_state(words.state_file);
        for (const auto& [name, value] : values) {
            request.state.build_values[name] = value;
        }
    }
    take_what_to_see(request.state, words);
    take_how_it_is_drawn(request.state, words);
    take_step(request, words.step);
    if (request.to_parting && request.state.structures.size() < 2) {
        throw InputError(
            "--step parting: one walk alone parts from none. Name two structures, as in "
            "--structure bvh_ordered,bvh_skip.");
    }
    return request;
}

} // namespace raysteps::view
