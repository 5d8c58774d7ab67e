#pragma once

#include "stage.h"

#include <string>

namespace raysteps::view {

// The state after a key, by its name in X11 (`n`, `Right`, `bracketleft`); the same state where the
// key means nothing to it. The stage shows the state.
State after_key(const State& state, const Stage& stage, const std::string& key);

// The state at that step, or at the first or last where there is no such one.
State with_step(State state, const Stage& stage, int step);

// The state with the cell marked that stands so many rows below in the table, which moves along.
State with_row(State state, const Stage& stage, int more);

} // namespace raysteps::view
