#include "file/write_file.h"

#include "error/error.h"

#include <cerrno>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

namespace raysteps {

namespace {

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
