#include "keys.h"

#include "cell_choice.h"
#include "finding.h"
#include "framing.h"
#include "layout.h"
#include "visualizer/replay/sentence.h"
#include "why.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace raysteps::view {

namespace {

int current_step(const State& state, const Stage& stage) {
    const int last = std::max(step_count(stage, state) - 1, 0);
    return state.step < 0 ? last : std::min(state.step, last);
}

// Where the walks part at different steps, pressing the key again jumps to the other step.
State at_parting(State state, const Stage& stage) {
    const auto parting = parting_of(stage, state);
    if (!parting) {
        return state;
    }
    const auto [earlier, later] = std::minmax(
        {static_cast<int>(parting->first_step), static_cast<int>(parting->second_step)});
    return with_step(state, stage, state.step == later ? earlier : later);
}

// Recorded steps are of one ray: there is nothing to count for the other pixels.
State with_next_heat_map(State state, const Stage&) {
    state.heat_map = state.steps.empty() ? next_of(state.heat_map) : state.heat_map;
    return state;
}

State with_next_ray(State state, const Stage& stage) {
    std::size_t rays = 1;
    for (const std::unique_ptr<Pane>& pane : stage.panes()) {
        rays = std::max(rays, pane->path.size());
    }
    state.path_ray = (state.path_ray + 1) % static_cast<int>(rays);
    state.step = last_step;
    return state;
}

// The triangle that the ray should come to, by the loop over all of them; pressed again, none.
State with_why(State state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    state.why = walk && state.why < 0 ? hit_by_loop(stage, walk->ray).triangle : no_triangle;
    return state;
}

State with_levels(State state, const Stage& stage, int lower, int upper) {
    const Levels levels = levels_of(*stage.panes().front(), state);
    const int deepest = stage.panes().front()->cells.deepest;
    state.levels.lowest = std::clamp(levels.lowest + lower, 0, deepest);
    state.levels.highest = std::clamp(levels.highest + upper, state.levels.lowest, deepest);
    return state;
}

// A plane across the axis through the middle of the scene; pressing the key again flips it, and a
// third time removes it.
State with_clip(State state, const Stage& stage, int axis) {
    glm::vec3 normal(0.0f);
    normal[axis] = 1.0f;
    if (state.clip && state.clip->normal == normal) {
        state.clip->normal = -normal;
    } else if (state.clip && state.clip->normal == -normal) {
        state.clip.reset();
    } else {
        const Box& bounds = stage.bounds();
        state.clip = ClipPlane{
            is_empty(bounds) ? glm::vec3(0.0f) : 0.5f * (bounds.lower + bounds.upper), normal};
    }
    return state;
}

State with_clip_moved(State state, const Stage& stage, float parts) {
    if (state.clip && !is_empty(stage.bounds())) {
        const glm::vec3 size = stage.bounds().upper - stage.bounds().lower;
        state.clip->point += parts * std::max({size.x, size.y, size.z}) * state.clip->normal;
    }
    return state;
}

State with_frame(State state, const Stage&) {
    state.viewpoint.reset();
    return state;
}

State with_flight(State state, const Stage& stage) {
    state.viewpoint = fly_to_step(stage, state);
    return state;
}

std::string text_of(bool is_on) {
    return is_on ? "on" : "off";
}

std::string text_of(int number) {
    return std::to_string(number);
}

std::string text_of(double number) {
    return short_number(number);
}

template <class Choice>
std::string text_of(Choice choice) {
    return word_of(choice);
}

std::string clip_text(const State& state) {
    if (!state.clip) {
        return "off";
    }
    const glm::vec3& n = state.clip->normal;
    return short_number(static_cast<double>(n.x)) + "," + short_number(static_cast<double>(n.y)) +
           "," + short_number(static_cast<double>(n.z));
}

std::string step_text(const State& state) {
    return state.step < 0 ? "last" : std::to_string(state.step + 1);
}

using After = std::function<State(State, const Stage&)>;
using Text = std::function<std::string(const State&)>;

// A key by its name in X11, and what it does: to the state, or to the window.
struct Key {
    std::string name;
    After after{};
    WindowAction action = WindowAction::none;

    Key(std::string key, After then) : name(std::move(key)), after(std::move(then)) {}
    Key(std::string key, WindowAction what) : name(std::move(key)), action(what) {}
};

// A line of the help sheet with its keys, and the current value of what they change.
struct KeyLine {
    std::string shown;
    std::string meaning;
    std::vector<Key> keys{};
    Text value{};
};

struct KeySection {
    std::string title;
    std::vector<KeyLine> lines;
};

After to_step(int step) {
    return [=](State s, const Stage& stage) { return with_step(std::move(s), stage, step); };
}

After by_steps(int more) {
    return [=](State s, const Stage& stage) {
        return with_step(s, stage, current_step(s, stage) + more);
    };
}

After by_levels(int lower, int upper) {
    return
        [=](State s, const Stage& stage) { return with_levels(std::move(s), stage, lower, upper); };
}

After by_opacity(double more) {
    return [=](State s, const Stage&) {
        s.opacity = std::clamp(s.opacity + more, 0.0, 1.0);
        return s;
    };
}

After clip_across(int axis) {
    return [=](State s, const Stage& stage) { return with_clip(std::move(s), stage, axis); };
}

After by_clip(float parts) {
    return [=](State s, const Stage& stage) { return with_clip_moved(std::move(s), stage, parts); };
}

After by_rows(int more) {
    return [=](State s, const Stage& stage) { return with_row(std::move(s), stage, more); };
}

After to_sibling(int more) {
    return [=](const State& s, const Stage& stage) { return with_sibling(s, stage, more); };
}

template <class Value>
After set(Value State::*member, Value value) {
    return [=](State s, const Stage&) {
        s.*member = value;
        return s;
    };
}

After turn(bool State::*member) {
    return [=](State s, const Stage&) {
        s.*member = !(s.*member);
        return s;
    };
}

template <class Choice>
After next_choice(Choice State::*member) {
    return [=](State s, const Stage&) {
        s.*member = next_of(s.*member);
        return s;
    };
}

template <class Value>
Text now(Value State::*member) {
    return [=](const State& s) { return text_of(s.*member); };
}

// The selected row stays in sight.
State with_next_order(State state, const Stage& stage) {
    state.sort_by = next_of(state.sort_by);
    state.first_row = 0;
    return with_row(state, stage, 0);
}

const std::vector<KeySection>& key_table() {
    using A = WindowAction;
    static const std::vector<KeySection> table{
        {"STEPS",
         {{"N  Right", "next step", {{"n", by_steps(1)}, {"Right", by_steps(1)}}, step_text},
          {"P  Left", "previous step", {{"p", by_steps(-1)}, {"Left", by_steps(-1)}}},
          {"Home  End",
           "first, last",
           {{"Home", to_step(0)}, {"End", set(&State::step, last_step)}}},
          {"Space", "play", {{"space", A::play}}},
          {"G", "on to the marked cell", {{"g", at_next_visit}}},
          {"A", "on to a test of the hit", {{"a", at_next_test}}},
          {"D", "where two walks part", {{"d", at_parting}}},
          {"L", "pixel where they differ", {{"l", at_next_difference}}},
          {"Tab", "next ray", {{"Tab", with_next_ray}}, now(&State::path_ray)},
          {"M",
           "why is the hit missed",
           {{"m", with_why}},
           [](const State& s) {
               return s.why < 0 ? std::string("off") : "triangle " + std::to_string(s.why);
           }},
          {"Ctrl+click", "why is that triangle missed"},
          {"click", "ray to that point, or of that pixel of a heat map"}}},
        {"CELLS",
         {{"V", "which ones", {{"v", next_choice(&State::filter)}}, now(&State::filter)},
          {"C", "color by", {{"c", next_choice(&State::color)}}, now(&State::color)},
          {"[  ]",
           "highest level",
           {{"bracketleft", by_levels(0, -1)}, {"bracketright", by_levels(0, 1)}}},
          {"{  }",
           "lowest level",
           {{"braceleft", by_levels(-1, 0)}, {"braceright", by_levels(1, 0)}},
           [](const State& s) { return std::to_string(s.levels.lowest); }},
          {"+  -",
           "opacity",
           {{"plus", by_opacity(0.05)}, {"equal", by_opacity(0.05)}, {"minus", by_opacity(-0.05)}},
           now(&State::opacity)},
          {"X  Y  Z",
           "clipping plane",
           {{"x", clip_across(0)}, {"y", clip_across(1)}, {"z", clip_across(2)}},
           clip_text},
          {",  .", "move it", {{"comma", by_clip(-0.05f)}, {"period", by_clip(0.05f)}}},
          {"B", "table of cells", {{"b", turn(&State::table)}}, now(&State::table)},
          {"J  Up  Down",
           "sort, select",
           {{"j", with_next_order},
            {"Up", by_rows(-1)},
            {"Down", by_rows(1)},
            {"Prior", by_rows(-20)},
            {"Next", by_rows(20)}},
           now(&State::sort_by)},
          {"Shift+click", "select a cell"},
          {"Return", "mark the step's cell", {{"Return", with_cell_of_step}}},
          {"Ctrl+arrows",
           "parent, child, siblings",
           {{"Control+Up", with_parent},
            {"Control+Down", with_child},
            {"Control+Left", to_sibling(-1)},
            {"Control+Right", to_sibling(1)}}}}},
        {"VIEW",
         {{"mouse", "orbit, move (middle), zoom (right, wheel)"},
          {"R  F", "all of it, fly to the step", {{"r", with_frame}, {"f", with_flight}}},
          {"W  S  T  O",
           "model",
           {{"w", set(&State::model, ModelStyle::wireframe)},
            {"s", set(&State::model, ModelStyle::solid)},
            {"t", set(&State::model, ModelStyle::transparent)},
            {"o", set(&State::model, ModelStyle::hidden)}},
           now(&State::model)},
          {"I", "heat map", {{"i", with_next_heat_map}}, now(&State::heat_map)},
          {"U",
           "own scale for each map",
           {{"u", turn(&State::own_scales)}},
           now(&State::own_scales)},
          {"Ctrl+Z  Y", "undo, redo", {{"Control+z", A::undo}, {"Control+y", A::redo}}},
          {"F12  K", "save picture, state", {{"F12", A::save_picture}, {"k", A::save_state}}},
          {"H  Q",
           "this sheet, quit",
           {{"h", turn(&State::help)}, {"q", A::quit}, {"e", A::quit}}}}}};
    return table;
}

const Key* find_key(const std::string& name) {
    for (const KeySection& section : key_table()) {
        for (const KeyLine& line : section.lines) {
            for (const Key& key : line.keys) {
                if (key.name == name) {
                    return &key;
                }
            }
        }
    }
    return nullptr;
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string line_text(const KeyLine& line, const State& state) {
    const std::string text = " " + padded(line.shown, 14);
    return line.value ? text + padded(line.meaning, 23) + "now " + line.value(state)
                      : text + line.meaning;
}

} // namespace

State after_key(const State& state, const Stage& stage, const std::string& name) {
    const Key* const key = find_key(name);
    return key && key->after ? key->after(state, stage) : state;
}

bool changes_state(const std::string& name) {
    const Key* const key = find_key(name);
    return key && key->after;
}

WindowAction window_action(const std::string& name) {
    const Key* const key = find_key(name);
    return key ? key->action : WindowAction::none;
}

std::string help_text(const State& state) {
    std::string text;
    for (const KeySection& section : key_table()) {
        text += (text.empty() ? " " : "\n ") + section.title + "\n";
        for (const KeyLine& line : section.lines) {
            text += line_text(line, state) + " \n";
        }
    }
    text.pop_back();
    return text;
}

State with_step(State state, const Stage& stage, int step) {
    const int last = std::max(step_count(stage, state) - 1, 0);
    state.step = std::clamp(step, 0, last);
    return state;
}

State with_row(State state, const Stage& stage, int more) {
    const std::vector<int> order = sorted_cells(*stage.panes().front(), state);
    if (!state.table || order.empty()) {
        return state;
    }
    const auto place = std::find(order.begin(), order.end(), state.selected);
    if (more == 0 && place == order.end()) {
        return state;
    }
    const int row = place == order.end() ? state.first_row - (more > 0 ? 1 : 0)
                                         : static_cast<int>(place - order.begin());
    const int next = std::clamp(row + more, 0, static_cast<int>(order.size()) - 1);
    const int rows = table_rows(layout_of(state, stage.panes().size()));
    state.selected = order[static_cast<std::size_t>(next)];
    state.first_row = std::clamp(state.first_row, next - rows + 1, next);
    return state;
}

} // namespace raysteps::view
