#include "scene/obj_paths.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace raysteps {

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::optional<std::filesystem::path> path_inside(const std::filesystem::path& inside,
                                                 const std::filesystem::path& from,
                                                 std::string_view name) {
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const std::filesystem::path named(slashed);
    if (named.empty())
        return std::nullopt;
    const std::filesystem::path path = (from / named).lexically_normal();

    std::error_code failure;
    const std::filesystem::path root = std::filesystem::weakly_canonical(inside, failure);
    if (failure)
        return std::nullopt;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, failure);
    if (failure)
        return std::nullopt;
    const std::filesystem::path way = target.lexically_relative(root);
    if (way.empty() || *way.begin() == "..")
        return std::nullopt;
    return path;
}

} // namespace raysteps
