#pragma once

#include <filesystem>
#include <string>

namespace raysteps {

// The folder `shaders` or `scripts`: that of the sources, which the caller was compiled with; where
// it is gone, that of an installation, share/raysteps/NAME beside the program's own folder or of
// the prefix that was configured.
std::filesystem::path data_folder(const std::filesystem::path& of_sources, const std::string& name);

// A program that this one calls: as it was built; where that is gone, the one of its name beside
// this one, or in lib/raysteps of the prefix that was configured.
std::filesystem::path helper_program(const std::filesystem::path& built);

} // namespace raysteps
