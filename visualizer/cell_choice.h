#pragma once

#include "stage.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raysteps::view {

// Levels of a tree, from the root's, 0, on; both ends count.
struct Levels {
    int lowest = 0;
    int highest = 0;
};

// Those of the state; where it names no highest one, as many as can be told apart, or of a walk
// all.
Levels levels_of(const Pane& pane, const State& state);

// The cells that a state shows of a structure.
struct CellChoice {
    std::vector<int> cells;
    std::size_t left_out = 0; // beyond the most that are drawn
};

CellChoice choose_cells(const Pane& pane, const State& state);

// How often the state's walk comes to each cell up to the state's step, by cell; empty where there
// is no walk.
std::vector<int> visits_of(const Pane& pane, const State& state);

// What the colour of each of these cells tells: its depth, triangles, cost or visits.
std::vector<double> color_values(const Pane& pane, const State& state,
                                 const std::vector<int>& cells);

// The values of the first and the last colour, for all panes alike: of depths all there are, else
// those of the cells that are drawn.
struct ValueRange {
    double lower = 0.0;
    double upper = 1.0;
};

ValueRange color_range(const Stage& stage, const State& state);

std::string color_title(CellColor color);

// The surface of a cell's box.
double area_of(const Cell& cell);

// The cells in the order of the table.
std::vector<int> sorted_cells(const Pane& pane, const State& state);

} // namespace raysteps::view
