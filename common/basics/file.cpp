#include "basics/file.h"

#include "basics/error.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
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
        throw InputError(name + ": cannot be accessed (" + failure.message() +
                         "). Check its name and its permissions.");
    if (std::filesystem::is_directory(status))
        throw InputError(name + ": is a folder, not a file. Name a file in it.");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(name + ": is a device or a pipe, not a regular file. Copy it to a file.");
    const std::uintmax_t size = std::filesystem::file_size(path, failure);
    if (failure)
        throw InputError(name + ": its size cannot be read (" + failure.message() + ").");
    if (size > most_bytes)
        throw InputError(name + ": has " + std::to_string(size) + " bytes, but the limit is " +
                         std::to_string(most_bytes) + ". Split it into smaller files.");
    return size;
}

std::error_code last_error() {
    return {errno != 0 ? errno : EIO, std::generic_category()};
}

// The file must be new ("x"): no two writers ever share one.
std::error_code write_new_file(const std::filesystem::path& path, std::string_view bytes) {
    errno = 0;
    std::FILE* file = std::fopen(path.string().c_str(), "wbx");
    if (file == nullptr) {
        return last_error();
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const std::error_code write_error = written ? std::error_code() : last_error();
    if (std::fclose(file) != 0 && !write_error) {
        return last_error();
    }
    return write_error;
}

// Its length does not grow with the file's own name, which may be as long as the system allows.
std::filesystem::path name_beside(const std::filesystem::path& path) {
    std::random_device random;
    const std::string name = ".partly-written-" + std::to_string(random());
    return path.parent_path() / name;
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw InputError(path.string() + ": cannot be written: " + reason +
                     ". Choose another path, or make room and allow writing there.");
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

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code error;
    if (!path.has_filename()) {
        fail(path, "it names no file");
    }
    // Renaming would replace a device such as /dev/null by a file.
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
        fail(path, "it is a folder or a device, not a file");
    }
    if (path.has_parent_path()) {
        std::filesystem::create_directories(path.parent_path(), error);
        if (error) {
            fail(path, "its folder cannot be made: " + error.message());
        }
    }
    const std::filesystem::path partly_written = name_beside(path);
    error = write_new_file(partly_written, bytes);
    if (!error) {
        std::filesystem::rename(partly_written, path, error);
    }
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(partly_written, ignored);
        fail(path, error.message());
    }
}

} // namespace raysteps
