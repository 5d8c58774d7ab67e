#pragma once

#include "stage.h"

#include <string>

namespace raysteps::view {

// The state after a key, by its name in X11 (`n`, `Right`, `bracketleft`), after `Control+` where
// that is held; the same state where the key does nothing to it. The stage shows the state.
State after_key(const State& state, const Stage& stage, const std::string& key);

bool changes_state(const std::string& key);

// What a key does that only a window can do.
enum class WindowAction { none, play, undo, redo, save_picture, save_state, quit };

WindowAction window_action(const std::string& key);

// What each key does, with the current values.
std::string help_text(const State& state);

// The state at that step, or at the first or last one where there is no such step.
State with_step(State state, const Stage& stage, int step);

// The state with the selection moved down by so many rows of the table, which scrolls along.
State with_row(State state, const Stage& stage, int more);

} // namespace raysteps::view
