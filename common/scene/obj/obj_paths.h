#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace raysteps {

// The folder that a file stands in; "." where the path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

// Where a file that is named in another file stands: the name, seen from the folder `from`.
// Nothing where that is outside the folder `inside`, also by way of a symbolic link. A backslash
// counts as a slash, since files from Windows are full of them. The file need not exist.
std::optional<std::filesystem::path> path_inside(const std::filesystem::path& inside,
                                                 const std::filesystem::path& from,
                                                 std::string_view name);

} // namespace raysteps
