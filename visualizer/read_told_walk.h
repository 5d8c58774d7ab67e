#pragma once

#include "visualizer/replay/told_walk.h"

#include <filesystem>

namespace raysteps::view {

// Reads a file of recorded steps (walk.schema.json). Throws InputError with the file's name where
// it is none.
ToldWalk read_told_walk(const std::filesystem::path& path);

} // namespace raysteps::view
