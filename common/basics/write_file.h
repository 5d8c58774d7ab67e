#pragma once

#include <filesystem>
#include <string_view>

namespace raysteps {

// Writes the bytes to a new file in the same folder, and then gives it the name: a write that
// fails leaves the old file as it was. Makes the folders that lack.
// Throws InputError with the path and the reason where it fails.
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace raysteps
