#pragma once

#include <filesystem>

namespace raysteps::view {

// Writes all files of the folder to one ZIP archive. Throws InputError where it cannot be written.
void zip_folder(const std::filesystem::path& folder, const std::filesystem::path& archive);

} // namespace raysteps::view
