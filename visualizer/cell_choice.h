#pragma once

#include "pane.h"

#include <cstddef>
#include <vector>

namespace raysteps::view {

// The levels that a state shows. Where it names no highest one: all levels of a walk, otherwise as
// many as can be told apart.
Levels levels_of(const Pane& pane, const State& state);

// The cells that a state shows of a structure.
struct CellChoice {
    std::vector<int> cells;
    std::size_t left_out = 0; // because they are too many to draw
};

CellChoice choose_cells(const Pane& pane, const State& state);

// How often the state's walk has come to each cell by the state's step; empty without a walk.
std::vector<int> visits_of(const Pane& pane, const State& state);

// The cells in the order of the table.
std::vector<int> sorted_cells(const Pane& pane, const State& state);

} // namespace raysteps::view
