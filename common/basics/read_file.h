#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raysteps {

// The bytes of a regular file, of at most most_bytes. Folders, pipes and devices are refused before
// they are opened: reading them could fail quietly, wait, or never end.
// Throws InputError that names the file.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

} // namespace raysteps
