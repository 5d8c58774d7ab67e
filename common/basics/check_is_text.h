#pragma once

#include <filesystem>
#include <string_view>

namespace raysteps {

// Throws InputError that names the file and the line where a zero byte shows that this is no text.
void check_is_text(std::string_view text, const std::filesystem::path& path);

} // namespace raysteps
