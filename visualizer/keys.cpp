#include "keys.h"

#include "cell_choice.h"
#include "layout.h"
#include "state_words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace raysteps::view {

namespace {

int current_step(const State& state, const Stage& stage) {
    const int last = std::max(step_count(stage, state) - 1, 0);
    return state.step < 0 ? last : std::min(state.step, last);
}

// Where the walks part at different steps, the same key again jumps to the other one.
State at_parting(State state, const Stage& stage) {
    const auto parting = parting_of(stage, state);
    if (!parting) {
        return state;
    }
    const auto [earlier, later] = std::minmax(
        {static_cast<int>(parting->first_step), static_cast<int>(parting->second_step)});
    return with_step(state, stage, state.step == later ? earlier : later);
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

State with_levels(State state, const Stage& stage, int lower, int upper) {
    const Levels levels = levels_of(*stage.panes().front(), state);
    const int deepest = stage.panes().front()->cells.deepest;
    state.lowest_level = std::clamp(levels.lowest + lower, 0, deepest);
    state.highest_level = std::clamp(levels.highest + upper, state.lowest_level, deepest);
    return state;
}

// Across the axis through the middle of the scene; the same key again turns it round, and then
// takes it away.
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

State with_opacity(State state, double more) {
    state.opacity = std::clamp(state.opacity + more, 0.0, 1.0);
    return state;
}

using After = std::function<State(State, const Stage&)>;

const std::map<std::string, After>& key_table() {
    static const After next = [](State s, const Stage& stage) {
        return with_step(s, stage, current_step(s, stage) + 1);
    };
    static const After previous = [](State s, const Stage& stage) {
        return with_step(s, stage, current_step(s, stage) - 1);
    };
    static const auto style = [](ModelStyle model) {
        return [model](State s, const Stage&) {
            s.model = model;
            return s;
        };
    };
    static const auto clip = [](int axis) {
        return [axis](State s, const Stage& stage) { return with_clip(std::move(s), stage, axis); };
    };
    static const auto levels = [](int lower, int upper) {
        return [=](State s, const Stage& stage) {
            return with_levels(std::move(s), stage, lower, upper);
        };
    };
    static const std::map<std::string, After> all{
        {"n", next},
        {"Right", next},
        {"p", previous},
        {"Left", previous},
        {"Home", [](State s, const Stage& stage) { return with_step(std::move(s), stage, 0); }},
        {"End",
         [](State s, const Stage&) {
             s.step = last_step;
             return s;
         }},
        {"d", at_parting},
        {"Tab", with_next_ray},
        {"w", style(ModelStyle::wireframe)},
        {"s", style(ModelStyle::solid)},
        {"t", style(ModelStyle::transparent)},
        {"o", style(ModelStyle::hidden)},
        {"v",
         [](State s, const Stage&) {
             s.filter = next_of(filter_words(), s.filter);
             return s;
         }},
        {"c",
         [](State s, const Stage&) {
             s.color = next_of(color_words(), s.color);
             return s;
         }},
        {"plus", [](State s, const Stage&) { return with_opacity(std::move(s), 0.05); }},
        {"equal", [](State s, const Stage&) { return with_opacity(std::move(s), 0.05); }},
        {"minus", [](State s, const Stage&) { return with_opacity(std::move(s), -0.05); }},
        {"bracketleft", levels(0, -1)},
        {"bracketright", levels(0, 1)},
        {"braceleft", levels(-1, 0)},
        {"braceright", levels(1, 0)},
        {"x", clip(0)},
        {"y", clip(1)},
        {"z", clip(2)},
        {"comma",
         [](State s, const Stage& stage) { return with_clip_moved(std::move(s), stage, -0.05f); }},
        {"period",
         [](State s, const Stage& stage) { return with_clip_moved(std::move(s), stage, 0.05f); }},
        {"i",
         [](State s, const Stage&) {
             s.heat_map = next_of(heat_map_words(), s.heat_map);
             return s;
         }},
        {"b",
         [](State s, const Stage&) {
             s.table = !s.table;
             return s;
         }},
        {"j",
         [](State s, const Stage&) {
             s.sort_by = next_of(sort_words(), s.sort_by);
             s.first_row = 0;
             return s;
         }},
        {"Down", [](State s, const Stage& stage) { return with_row(std::move(s), stage, 1); }},
        {"Up", [](State s, const Stage& stage) { return with_row(std::move(s), stage, -1); }},
        {"Next", [](State s, const Stage& stage) { return with_row(std::move(s), stage, 20); }},
        {"Prior", [](State s, const Stage& stage) { return with_row(std::move(s), stage, -20); }},
        {"h",
         [](State s, const Stage&) {
             s.help = !s.help;
             return s;
         }},
    };
    return all;
}

} // namespace

State after_key(const State& state, const Stage& stage, const std::string& key) {
    const auto place = key_table().find(key);
    return place == key_table().end() ? state : place->second(state, stage);
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
