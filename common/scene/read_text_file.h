#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace raysteps {

// The bytes of a regular file, of at most most_bytes. Directories, pipes and devices are refused
// before they are opened: reading them could fail quietly, wait, or never end.
// Throws InputError that names the file.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

// Throws InputError that names the file and the line where a zero byte shows that this is no text.
void check_is_text(std::string_view text, const std::filesystem::path& path);

} // namespace raysteps
