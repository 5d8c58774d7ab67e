#include "scene/check_is_text.h"

#include "error/error.h"

#include <algorithm>
#include <string>

namespace raysteps {

void check_is_text(std::string_view text, const std::filesystem::path& path) {
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos)
        return;
    const auto lines_before = std::count(text.begin(), text.begin() + zero, '\n');
    throw InputError(path.string() + ":" + std::to_string(lines_before + 1) +
                     ": holds a zero byte, so it is no plain text. Save it as UTF-8 text.");
}

} // namespace raysteps
