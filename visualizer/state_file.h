#pragma once

#include "state.h"

#include <filesystem>
#include <string>

namespace raysteps::view {

// A state as JSON, and back: the same state, bit for bit.
std::string state_text(const State& state);

// Throws InputError with the name and the field where the text is no state. What it does not name
// is as in State{}.
State parse_state(const std::string& text, const std::string& name);

State read_state(const std::filesystem::path& path);
void save_state(const std::filesystem::path& path, const State& state);

} // namespace raysteps::view
