#include "program/window/screenshot_path.h"

#include <string>

namespace raysteps {

std::filesystem::path screenshot_path(const std::filesystem::path& name) {
    for (int number = 1;; ++number) {
        std::filesystem::path path = name;
        path += "-" + std::to_string(number) + ".png";
        std::error_code error;
        // A link that points nowhere would be written through: it counts as taken. Where the
        // folder cannot be looked into, writing says why.
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
            return path;
        }
    }
}

} // namespace raysteps
