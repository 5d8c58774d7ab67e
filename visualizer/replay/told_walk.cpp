#include "told_walk.h"

#include "basics/text.h"
#include "walk_recorder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace raysteps {

namespace {

// The cell of each place that has a box, in the order in which the walk comes to them.
std::map<int, int> cells_of_places(const ToldWalk& told) {
    std::map<int, int> cells;
    for (const ToldStep& step : told.steps) {
        if (step.box) {
            cells.try_emplace(step.place, static_cast<int>(cells.size()));
        }
    }
    return cells;
}

Outcome outcome_of(const ToldStep& step) {
    return step.outcome.value_or(step.tested.empty() ? Outcome::entered : Outcome::leaf);
}

// Where the ray is in the box: for a drawing, so its rounding does not matter.
std::pair<double, double> part_in(const Box& box, const Ray& ray) {
    double entry = ray.t_min;
    double exit = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            continue;
        }
        const double first = (static_cast<double>(box.lower[axis]) - ray.origin[axis]) / direction;
        const double last = (static_cast<double>(box.upper[axis]) - ray.origin[axis]) / direction;
        entry = std::max(entry, std::min(first, last));
        exit = std::min(exit, std::max(first, last));
    }
    return {entry, exit};
}

} // namespace

bool is_walk_of_ours(const ToldWalk& told) {
    const std::vector<std::string> names = recorded_structures();
    const std::vector<std::string> words = split_words(told.structure, ':');
    return !words.empty() && std::find(names.begin(), names.end(), words.front()) != names.end();
}

StructureCells told_cells(const ToldWalk& told) {
    StructureCells structure;
    const std::map<int, int> cells = cells_of_places(told);
    if (cells.empty()) {
        return structure;
    }
    structure.kind = CellKind::bvh;
    structure.cells.resize(cells.size());
    for (const ToldStep& step : told.steps) {
        if (step.box) {
            Cell& cell = structure.cells[static_cast<std::size_t>(cells.at(step.place))];
            cell.box = *step.box;
            cell.leaf = outcome_of(step) == Outcome::leaf;
            cell.triangles = std::max(cell.triangles, static_cast<int>(step.tested.size()));
        }
    }
    return structure;
}

RecordedWalk walk_in_told_cells(const ToldWalk& told, RecordedWalk tests) {
    const std::map<int, int> cells = cells_of_places(told);
    for (std::size_t i = 0; i < told.steps.size(); ++i) {
        const ToldStep& said = told.steps[i];
        if (said.box) {
            Step& step = tests.steps[i];
            step.cell = cells.at(said.place);
            step.outcome = outcome_of(said);
            const auto [entry, exit] = part_in(*said.box, told.ray);
            step.entry = static_cast<float>(entry);
            step.exit = static_cast<float>(exit);
        }
    }
    return tests;
}

} // namespace raysteps
