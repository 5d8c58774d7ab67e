#include "cell_choice.h"

#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <numeric>

namespace raysteps::view {

namespace {

constexpr std::size_t easily_seen = 600; // boxes that can be told apart

std::vector<int> cells_visited(const Pane& pane, const State& state) {
    const RecordedWalk* walk = walk_in(pane, state);
    std::vector<int> cells;
    if (!walk || walk->steps.empty()) {
        return cells;
    }
    const std::size_t last = step_in(*walk, state);
    for (std::size_t i = 0; i <= last; ++i) {
        const Step& step = walk->steps[i];
        const bool tested = step.end_test > step.first_test;
        const bool wanted = state.filter == CellFilter::tested ? tested : !is_culled(step.outcome);
        if (step.cell != no_cell && wanted) {
            cells.push_back(step.cell);
        }
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

bool is_of_walk(CellFilter filter) {
    return filter == CellFilter::visited || filter == CellFilter::tested;
}

} // namespace

Levels levels_of(const Pane& pane, const State& state) {
    const int deepest = pane.cells.deepest;
    Levels levels{std::clamp(state.levels.lowest, 0, deepest), deepest};
    if (state.levels.highest >= 0) {
        levels.highest = std::clamp(state.levels.highest, levels.lowest, deepest);
        return levels;
    }
    if (is_of_walk(state.filter)) {
        return levels;
    }
    std::vector<std::size_t> at_level(static_cast<std::size_t>(deepest) + 1, 0);
    for (const Cell& cell : pane.cells.cells) {
        ++at_level[static_cast<std::size_t>(cell.depth)];
    }
    std::size_t seen = 0;
    int level = 0;
    for (; level <= deepest; ++level) {
        seen += at_level[static_cast<std::size_t>(level)];
        if (seen > easily_seen) {
            break;
        }
    }
    levels.highest = std::clamp(level - 1, levels.lowest, deepest);
    return levels;
}

CellChoice choose_cells(const Pane& pane, const State& state) {
    const Levels levels = levels_of(pane, state);
    std::vector<int> candidates;
    if (is_of_walk(state.filter)) {
        candidates = cells_visited(pane, state);
    } else {
        candidates.resize(pane.cells.cells.size());
        std::iota(candidates.begin(), candidates.end(), 0);
    }
    const auto most = static_cast<std::size_t>(std::max(state.most_cells, 0));
    CellChoice choice;
    for (const int number : candidates) {
        const Cell& cell = pane.cells.cells[static_cast<std::size_t>(number)];
        const bool hidden = cell.depth < levels.lowest || cell.depth > levels.highest ||
                            (state.filter == CellFilter::occupied && cell.triangles == 0);
        if (hidden) {
            continue;
        }
        if (choice.cells.size() < most) {
            choice.cells.push_back(number);
        } else {
            ++choice.left_out;
        }
    }
    return choice;
}

std::vector<int> visits_of(const Pane& pane, const State& state) {
    const RecordedWalk* walk = walk_in(pane, state);
    if (!walk || walk->steps.empty()) {
        return {};
    }
    std::vector<int> visits(pane.cells.cells.size(), 0);
    const std::size_t last = step_in(*walk, state);
    for (std::size_t i = 0; i <= last; ++i) {
        if (walk->steps[i].cell != no_cell) {
            ++visits[static_cast<std::size_t>(walk->steps[i].cell)];
        }
    }
    return visits;
}

std::vector<int> sorted_cells(const Pane& pane, const State& state) {
    const std::vector<Cell>& cells = pane.cells.cells;
    std::vector<int> order(cells.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int number) {
        const Cell& cell = cells[static_cast<std::size_t>(number)];
        switch (state.sort_by) {
        case SortBy::id:
            return static_cast<double>(number);
        case SortBy::depth:
            return static_cast<double>(cell.depth);
        case SortBy::count:
            return static_cast<double>(cell.triangles);
        case SortBy::area:
            return surface_area(cell.box);
        case SortBy::cost:
            break;
        }
        return cell.cost;
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return state.descending ? key(a) > key(b) : key(a) < key(b);
    });
    return order;
}

} // namespace raysteps::view
