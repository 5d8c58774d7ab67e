#include "basics/data_folder.h"

#include <system_error>

namespace raysteps {

std::filesystem::path data_folder(const std::filesystem::path& of_sources,
                                  const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::is_directory(of_sources, ignored)) {
        return of_sources;
    }
    // bin/PROGRAM, or lib/raysteps/PROGRAM
    std::filesystem::path above = std::filesystem::read_symlink("/proc/self/exe", ignored);
    for (int up = 0; up < 3; ++up) {
        above = above.parent_path();
        const std::filesystem::path installed = above / "share" / "raysteps" / name;
        if (std::filesystem::is_directory(installed, ignored)) {
            return installed;
        }
    }
    return std::filesystem::path(RAYSTEPS_PREFIX) / "share" / "raysteps" / name;
}

std::filesystem::path helper_program(const std::filesystem::path& built) {
    std::error_code ignored;
    if (std::filesystem::exists(built, ignored)) {
        return built;
    }
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path beside = own.parent_path() / built.filename();
    if (std::filesystem::exists(beside, ignored)) {
        return beside;
    }
    return std::filesystem::path(RAYSTEPS_PREFIX) / "lib" / "raysteps" / built.filename();
}

} // namespace raysteps
