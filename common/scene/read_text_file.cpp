#include "scene/read_text_file.h"

#include "error/error.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace raysteps {

namespace {

std::uintmax_t checked_size(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(path, failure);
    const std::string name = path.string();
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError(name + ": there is no such file. Check its name and folder.");
    if (failure)
        throw InputError(name + ": cannot be looked at (" + failure.message() +
                         "). Check its name and its permissions.");
    if (std::filesystem::is_directory(status))
        throw InputError(name + ": is a folder, not a file. Name a file in it.");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(name + ": is a device or a pipe, not a regular file. Copy it to a file.");
    const std::uintmax_t size = std::filesystem::file_size(path, failure);
    if (failure)
        throw InputError(name + ": its size cannot be told (" + failure.message() + ").");
    if (size > most_bytes)
        throw InputError(name + ": has " + std::to_string(size) + " bytes, but the limit is " +
                         std::to_string(most_bytes) + ". Split it into smaller files.");
    return size;
}

} // namespace

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    const std::uintmax_t size = checked_size(path, most_bytes);
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InputError(path.string() + ": cannot be opened. Check its permissions.");
    std::string text(static_cast<std::size_t>(size), '\0');
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (file.bad())
        throw InputError(path.string() + ": cannot be read to its end. Check the disk.");
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

void check_is_text(std::string_view text, const std::filesystem::path& path) {
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos)
        return;
    const auto lines_before = std::count(text.begin(), text.begin() + zero, '\n');
    throw InputError(path.string() + ":" + std::to_string(lines_before + 1) +
                     ": holds a zero byte, so it is no plain text. Save it as UTF-8 text.");
}

} // namespace raysteps
