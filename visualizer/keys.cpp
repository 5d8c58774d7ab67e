#include "visualizer/keys.h"

#include "scene/view.h"
#include "visualizer/cell_choice.h"
#include "visualizer/state_words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace raysteps::view {

namespace {

State with_step(State state, const Stage& stage, int step) {
    const int last = std::max(step_count(stage, state) - 1, 0);
    state.step = std::clamp(step, 0, last);
    return state;
}

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

double part_in(const Area& area, const glm::ivec2& place) {
    return std::clamp(static_cast<double>(place.x - area.x) / std::max(area.width, 1), 0.0, 1.0);
}

// The nearer end of the range follows the mouse.
State with_level_at(State state, const Stage& stage, double part) {
    const int deepest = stage.panes().front()->cells.deepest;
    const int level = std::min(static_cast<int>(part * (deepest + 1)), deepest);
    const Levels levels = levels_of(*stage.panes().front(), state);
    const bool lower = std::abs(level - levels.lowest) < std::abs(level - levels.highest);
    state.lowest_level = lower ? level : std::min(levels.lowest, level);
    state.highest_level = lower ? levels.highest : level;
    return state;
}

State after_table_click(State state, const Stage& stage, const Layout& layout,
                        const glm::ivec2& place) {
    const int row = (layout.table.y + layout.table.height - 1 - place.y) / row_height;
    if (row == 0) {
        const int column = std::clamp(5 * (place.x - layout.table.x - margin) /
                                          std::max(layout.table.width - 2 * margin, 1),
                                      0, 4);
        const SortBy sort_by = sort_words()[static_cast<std::size_t>(column)].second;
        state.descending = sort_by == state.sort_by ? !state.descending : true;
        state.sort_by = sort_by;
        state.first_row = 0;
        return state;
    }
    const std::vector<int> order = sorted_cells(*stage.panes().front(), state);
    const auto number = static_cast<std::size_t>(std::max(state.first_row, 0) + row - 1);
    if (number < order.size()) {
        state.selected = order[number];
    }
    return state;
}

std::optional<Ray> ray_through(const State& state, const Stage& stage, const Camera& viewpoint,
                               const glm::ivec2& place) {
    for (const Area& pane : layout_of(state, stage.panes().size()).panes) {
        if (holds(pane, place)) {
            const View view = view_of(viewpoint, static_cast<double>(pane.width) / pane.height);
            return pixel_ray(view, pane.width, pane.height, place.x - pane.x,
                             pane.height - 1 - (place.y - pane.y));
        }
    }
    return std::nullopt;
}

// The t at which the ray enters the box; nothing where it misses it.
std::optional<double> entry_of(const Ray& ray, const Box& box) {
    double entry = 0.0;
    double exit = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1.0 / static_cast<double>(ray.direction[axis]);
        const double a =
            (static_cast<double>(box.lower[axis]) - static_cast<double>(ray.origin[axis])) *
            inverse;
        const double b =
            (static_cast<double>(box.upper[axis]) - static_cast<double>(ray.origin[axis])) *
            inverse;
        entry = std::max(entry, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return entry <= exit ? std::optional(entry) : std::nullopt;
}

} // namespace

State after_key(const State& state, const Stage& stage, const std::string& key) {
    const auto place = key_table().find(key);
    return place == key_table().end() ? state : place->second(state, stage);
}

bool is_on_panel(const State& state, const Stage& stage, const glm::ivec2& place) {
    const Layout layout = layout_of(state, stage.panes().size());
    return std::none_of(layout.panes.begin(), layout.panes.end(),
                        [&](const Area& pane) { return holds(pane, place); });
}

State after_click(const State& state, const Stage& stage, const glm::ivec2& place) {
    const Layout layout = layout_of(state, stage.panes().size());
    if (holds(layout.step_slider, place) && step_count(stage, state) > 0) {
        const int steps = step_count(stage, state);
        return with_step(state, stage,
                         static_cast<int>(part_in(layout.step_slider, place) * steps));
    }
    if (holds(layout.level_slider, place)) {
        return with_level_at(state, stage, part_in(layout.level_slider, place));
    }
    if (holds(layout.opacity_slider, place)) {
        State next = state;
        next.opacity = part_in(layout.opacity_slider, place);
        return next;
    }
    if (state.table && holds(layout.table, place)) {
        return after_table_click(state, stage, layout, place);
    }
    for (const Area& area : layout.heat_maps) {
        const Area picture = picture_area(area, state.picture);
        if (holds(picture, place)) {
            State next = state;
            next.pixel = glm::ivec2((place.x - picture.x) * state.picture.x / picture.width,
                                    (picture.y + picture.height - 1 - place.y) * state.picture.y /
                                        picture.height);
            next.ray.reset();
            next.path_ray = 0;
            next.step = last_step;
            next.filter = CellFilter::visited;
            return next;
        }
    }
    return state;
}

State with_selected(const State& state, const Stage& stage, int cell) {
    State next = state;
    next.selected = cell;
    return with_row(std::move(next), stage, 0);
}

State with_ray_to(const State& state, const Stage& stage, const glm::vec3& point) {
    State next = state;
    next.ray = Ray{stage.camera().eye, point - stage.camera().eye, 0.0f,
                   std::numeric_limits<float>::max()};
    next.pixel.reset();
    next.path_ray = 0;
    next.step = last_step;
    next.filter = CellFilter::visited;
    return next;
}

std::optional<glm::vec3> point_under(const State& state, const Stage& stage,
                                     const Camera& viewpoint, const glm::ivec2& place) {
    const auto ray = ray_through(state, stage, viewpoint, place);
    if (!ray) {
        return std::nullopt;
    }
    const Hit hit = stage.panes().front()->recorder.record(*ray, Question::nearest).hit;
    if (hit.triangle == no_triangle) {
        return std::nullopt;
    }
    return ray->origin + hit.t * ray->direction;
}

int cell_under(const State& state, const Stage& stage, const Camera& viewpoint,
               const glm::ivec2& place) {
    const auto ray = ray_through(state, stage, viewpoint, place);
    int found = no_cell;
    double least = 0.0;
    if (!ray) {
        return found;
    }
    const Pane& pane = *stage.panes().front();
    for (const int number : choose_cells(pane, state).cells) {
        const Cell& cell = pane.cells.cells[static_cast<std::size_t>(number)];
        if (entry_of(*ray, cell.box) && (found == no_cell || area_of(cell) < least)) {
            found = number;
            least = area_of(cell);
        }
    }
    return found;
}

} // namespace raysteps::view
