#pragma once

#include "stage.h"

#include <filesystem>

namespace raysteps::view {

// Writes the walk of the state's ray through the stage's first structure, with the model, as
// walk.schema.json says (docs/figures.md). Throws InputError where the state has no ray, or the
// file cannot be written.
void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state);

} // namespace raysteps::view
