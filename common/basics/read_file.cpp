#include "file/read_file.h"

#include "error/error.h"

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

std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    const std::uintmax_t size = checked_size(path, most_bytes);
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InputError(path.string() + ": cannot be opened. Check its permissions.");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw InputError(path.string() + ": ended after " + std::to_string(file.gcount()) + " of " +
                         std::to_string(size) + " bytes. Try again when nothing else writes it.");
    return bytes;
}

} // namespace raysteps
