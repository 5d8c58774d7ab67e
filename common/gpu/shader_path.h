#pragma once

#include <filesystem>
#include <string>

namespace raysteps {

// Where a shader file is read from: the first of the folders that the environment variable
// RAYSTEPS_SHADERS names, with colons between them, that has the file; else the given folder. So a
// person's own version of a part takes the place of the project's, and nothing is edited.
std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& folder);

} // namespace raysteps
