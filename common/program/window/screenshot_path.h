#pragma once

#include <filesystem>

namespace raysteps {

// NAME-1.png, or NAME-2.png where that is there already, and so on: the first that is free.
std::filesystem::path screenshot_path(const std::filesystem::path& name);

} // namespace raysteps
