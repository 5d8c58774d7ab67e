#pragma once

#include "state.h"

#include <filesystem>
#include <string>

namespace raysteps::view {

// A state as JSON, and back: the same state, bit for bit.
std::string state_text(const State& state);

// A field that the text does not name is that of State{}. Throws InputError with the file's name
// and the field where the text is not a state.
State parse_state(const std::string& text, const std::string& name);

State read_state(const std::filesystem::path& path);
void save_state(const std::filesystem::path& path, const State& state);

} // namespace raysteps::view
