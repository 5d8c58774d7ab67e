#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raysteps {

// All bytes of a regular file. Throws InputError where there is none, where it has more than
// most_bytes, or where it cannot be read.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

} // namespace raysteps
