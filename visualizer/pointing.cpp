#include "pointing.h"

#include "cell_choice.h"
#include "keys.h"
#include "scene/scaling.h"
#include "scene/view.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raysteps::view {

namespace {

double part_in(const Area& area, const glm::ivec2& place) {
    return std::clamp(static_cast<double>(place.x - area.x) / std::max(area.width, 1), 0.0, 1.0);
}

// The nearer end of the range follows the mouse.
State with_level_at(State state, const Stage& stage, double part) {
    const int deepest = stage.panes().front()->cells.deepest;
    const int level = std::min(static_cast<int>(part * (deepest + 1)), deepest);
    const Levels levels = levels_of(*stage.panes().front(), state);
    const bool lower = std::abs(level - levels.lowest) < std::abs(level - levels.highest);
    state.levels.lowest = lower ? level : std::min(levels.lowest, level);
    state.levels.highest = lower ? levels.highest : level;
    return state;
}

State after_table_click(State state, const Stage& stage, const Layout& layout,
                        const glm::ivec2& place) {
    const int row = (layout.table.y + layout.table.height - 1 - place.y) / row_height;
    if (row == 0) {
        const int columns = static_cast<int>(words_of(state.sort_by).size());
        const int column = std::clamp(columns * (place.x - layout.table.x - margin) /
                                          std::max(layout.table.width - 2 * margin, 1),
                                      0, columns - 1);
        const auto sort_by = static_cast<SortBy>(column);
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

// The t at which the ray enters the box; nothing if it misses.
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
            next.steps.clear();
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
    const Ray ray{stage.camera().eye, point - stage.camera().eye, 0.0f,
                  std::numeric_limits<float>::max()};
    next.ray = scaled(ray, -state.scale_exponent); // a state has the lengths of the file
    next.pixel.reset();
    next.steps.clear();
    next.path_ray = 0;
    next.step = last_step;
    next.filter = CellFilter::visited;
    return next;
}

std::optional<glm::vec3> point_under(const State& state, const Stage& stage,
                                     const Camera& viewpoint, const glm::ivec2& place) {
    auto ray = ray_through(state, stage, viewpoint, place);
    const auto entry = ray ? entry_of(*ray, stage.bounds()) : std::nullopt;
    if (!entry) {
        return std::nullopt;
    }
    // From the box of the scene on: a viewpoint may be farther away than the structures' reach.
    const glm::vec3 start(glm::dvec3(ray->origin) + *entry * glm::dvec3(ray->direction));
    ray->origin = glm::clamp(start, stage.bounds().lower, stage.bounds().upper);
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
        if (entry_of(*ray, cell.box) && (found == no_cell || surface_area(cell.box) < least)) {
            found = number;
            least = surface_area(cell.box);
        }
    }
    return found;
}

} // namespace raysteps::view
