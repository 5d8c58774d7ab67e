#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace raysteps {

// The bytes of a regular file, of at most most_bytes. Folders, pipes and devices are refused before
// they are opened: reading them could fail quietly, wait, or never end.
// Throws InputError that names the file.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

// Writes the bytes to a new file in the same folder, and then gives it the name: a write that
// fails leaves the old file as it was. Makes missing folders.
// Throws InputError with the path and the reason where it fails.
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace raysteps
