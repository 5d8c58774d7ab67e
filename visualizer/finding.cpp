#include "finding.h"

#include "keys.h"
#include "mirror/trace_by_mirror.h"
#include "pointing.h"
#include "scene/view.h"

#include <algorithm>
#include <functional>
#include <span>

namespace raysteps::view {

namespace {

// The next step, round from the state's, of which that is true; the same state where there is none.
State at_next(const State& state, const Stage& stage, const RecordedWalk& walk,
              const std::function<bool(const Step&)>& is_sought) {
    const std::size_t count = walk.steps.size();
    for (std::size_t more = 1; more <= count; ++more) {
        const std::size_t step = (step_in(walk, state) + more) % count;
        if (is_sought(walk.steps[step])) {
            return with_step(state, stage, static_cast<int>(step));
        }
    }
    return state;
}

bool has_cell(const Pane& pane, int cell) {
    return cell >= 0 && static_cast<std::size_t>(cell) < pane.cells.cells.size();
}

// Only that many rays at once, so that a difference near by is found at once.
constexpr int rows_at_once = 16;

std::vector<Hit> hits_of(const Stage& stage, const Pane& pane, std::span<const Ray> rays) {
    return mirror_walks().at(pane.structure)(stage.buffers(), pane.built.packed, rays);
}

bool differ(const Hit& one, const Hit& other) {
    return one.triangle != other.triangle || (one.triangle != no_triangle && one.t != other.t);
}

State at_pixel(const State& state, const glm::ivec2& pixel) {
    State next = state;
    next.pixel = pixel;
    next.ray.reset();
    next.path_ray = 0;
    next.step = last_step;
    next.why = no_triangle;
    next.filter = CellFilter::visited;
    return next;
}

} // namespace

State at_next_visit(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    if (!walk || state.selected < 0) {
        return state;
    }
    return at_next(state, stage, *walk,
                   [&](const Step& step) { return step.cell == state.selected; });
}

State at_next_test(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    const int triangle = !walk ? no_triangle : state.why >= 0 ? state.why : walk->hit.triangle;
    if (triangle == no_triangle) {
        return state;
    }
    return at_next(state, stage, *walk, [&](const Step& step) {
        const auto tests = tests_of(*walk, step);
        return std::any_of(tests.begin(), tests.end(),
                           [&](const TriangleTest& test) { return test.triangle == triangle; });
    });
}

State at_next_difference(const State& state, const Stage& stage) {
    const auto& panes = stage.panes();
    if (panes.size() < 2 || !state.steps.empty() || !panes[0]->refusal.empty() ||
        !panes[1]->refusal.empty()) {
        return state;
    }
    const glm::ivec2 size = state.picture;
    const std::vector<Ray> rays = pixel_rays(
        raysteps::view_of(stage.camera(), static_cast<double>(size.x) / size.y), size.x, size.y);
    const int count = size.x * size.y;
    const int start = state.pixel ? state.pixel->y * size.x + state.pixel->x + 1 : 0;
    const int at_once = rows_at_once * size.x;
    for (int done = 0; done < count; done += at_once) {
        std::vector<Ray> some;
        for (int i = done; i < std::min(done + at_once, count); ++i) {
            some.push_back(rays[static_cast<std::size_t>((start + i) % count)]);
        }
        const std::vector<Hit> first = hits_of(stage, *panes[0], some);
        const std::vector<Hit> second = hits_of(stage, *panes[1], some);
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (differ(first[i], second[i])) {
                const int pixel = (start + done + static_cast<int>(i)) % count;
                return at_pixel(state, {pixel % size.x, pixel / size.x});
            }
        }
    }
    return state;
}

State with_cell_of_step(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    if (!walk || walk->steps.empty()) {
        return state;
    }
    const int cell = walk->steps[step_in(*walk, state)].cell;
    return cell == no_cell ? state : with_selected(state, stage, cell);
}

State with_parent(const State& state, const Stage& stage) {
    const Pane& pane = *stage.panes().front();
    if (!has_cell(pane, state.selected)) {
        return state;
    }
    const int parent = pane.cells.cells[static_cast<std::size_t>(state.selected)].parent;
    return parent == no_cell ? state : with_selected(state, stage, parent);
}

State with_child(const State& state, const Stage& stage) {
    const std::vector<Cell>& cells = stage.panes().front()->cells.cells;
    const auto child = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
        return state.selected >= 0 && cell.parent == state.selected;
    });
    return child == cells.end()
               ? state
               : with_selected(state, stage, static_cast<int>(child - cells.begin()));
}

State with_sibling(const State& state, const Stage& stage, int more) {
    const Pane& pane = *stage.panes().front();
    if (!has_cell(pane, state.selected)) {
        return state;
    }
    const int parent = pane.cells.cells[static_cast<std::size_t>(state.selected)].parent;
    std::vector<int> children;
    for (std::size_t i = 0; parent != no_cell && i < pane.cells.cells.size(); ++i) {
        if (pane.cells.cells[i].parent == parent) {
            children.push_back(static_cast<int>(i));
        }
    }
    const auto own = std::find(children.begin(), children.end(), state.selected);
    if (own == children.end()) {
        return state;
    }
    const int count = static_cast<int>(children.size());
    const int place = static_cast<int>(own - children.begin());
    return with_selected(state, stage,
                         children[static_cast<std::size_t>((place + more + count) % count)]);
}

} // namespace raysteps::view
