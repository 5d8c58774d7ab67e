#pragma once

#include "stage.h"

#include <string>

namespace raysteps::view {

// Where else to look: other steps of the walk, other rays, relatives of the marked cell, and cells
// that somebody names. All of the first structure.

// The next step at the marked cell; after the last one, the first again. The same state where the
// walk never comes to it.
State at_next_visit(const State& state, const Stage& stage);

// The next step that tests the triangle that is asked about, or else the walk's hit.
State at_next_test(const State& state, const Stage& stage);

// The next pixel of the picture, row by row and round, in which the first two structures lead to
// different answers. The same state where there is none.
State at_next_difference(const State& state, const Stage& stage);

// The cell of the walk's step is marked.
State with_cell_of_step(const State& state, const Stage& stage);

// Its parent, its first child, or the child of its parent that is so many places farther on.
State with_parent(const State& state, const Stage& stage);
State with_child(const State& state, const Stage& stage);
State with_sibling(const State& state, const Stage& stage, int more);

// What somebody looks for, and what that is in words, or why there is none.
struct Found {
    int cell = no_cell;
    std::string words;
};

// `57` is the cell of that number, `t17` the next one after the marked cell that lists triangle 17,
// and `0.5,1,2` the smallest one around that point, in the lengths of the file.
Found find_cell(const Stage& stage, const State& state, const std::string& text);

// The state with that cell marked. Throws InputError where there is none.
State with_found(const State& state, const Stage& stage, const std::string& text);

} // namespace raysteps::view
