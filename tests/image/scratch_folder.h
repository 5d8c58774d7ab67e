#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// A folder of one test's own, empty at first, removed at the end.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& name);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    int file_count() const;

private:
    std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& path);

void put_bytes(const std::filesystem::path& path, std::string_view bytes);
