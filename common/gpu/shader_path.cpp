#include "gpu/shader_path.h"

#include <cstdlib>
#include <sstream>

namespace raysteps {

std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& folder) {
    const char* named = std::getenv("RAYSTEPS_SHADERS"); // NOLINT(concurrency-mt-unsafe)
    std::istringstream folders(named == nullptr ? "" : named);
    std::string first;
    while (std::getline(folders, first, ':')) {
        const std::filesystem::path path = std::filesystem::path(first) / file;
        if (!first.empty() && std::filesystem::is_regular_file(path)) {
            return path;
        }
    }
    return folder / file;
}

} // namespace raysteps
