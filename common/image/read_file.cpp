#include "image/read_file.h"

#include "error/error.h"

#include <fstream>
#include <system_error>

namespace raysteps {

std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw InputError(path.string() +
                         ": cannot be read: there is no such file. Check the path.");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(path.string() +
                         ": cannot be read: it is a folder or a device. Name a file.");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > most_bytes) {
        throw InputError(path.string() + ": has " + std::to_string(size) +
                         " bytes, over the limit of " + std::to_string(most_bytes) +
                         ". Use a smaller file.");
    }
    std::ifstream file(path, std::ios::binary);
    if (error || !file) {
        throw InputError(path.string() + ": cannot be opened. Check that you may read it.");
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
        throw InputError(path.string() + ": ended after " + std::to_string(file.gcount()) + " of " +
                         std::to_string(size) + " bytes. Try again when nothing else writes it.");
    }
    return bytes;
}

} // namespace raysteps
