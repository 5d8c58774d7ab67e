#pragma once

#include "basics/numbers.h"
#include "image/image.h"

#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace raysteps {

// Each writes a file, with the folders that lack, and prints its path.
void write_text(const std::filesystem::path& path, const std::string& text);
void write_picture(const std::filesystem::path& path, const Image& image); // a PNG

// "wrote     PATH", for a file that something else wrote.
void print_written(const std::filesystem::path& path);

// A name for the pictures of a scene: `sphereflake:3` becomes sphereflake_3, a path its stem.
std::string picture_name(const std::string& scene);

// A line that shows how far a long work is, with the time that is left. On a terminal it changes;
// in a pipe there is one every ten seconds.
std::function<void(double part_done)> show_progress(const std::string& work);

// A line that says what is being done, for as long as this lives; in a pipe, one every ten seconds.
// For work that does not know how far it is.
class WorkNotice {
public:
    explicit WorkNotice(const std::string& work);
    ~WorkNotice();
    WorkNotice(const WorkNotice&) = delete;
    WorkNotice& operator=(const WorkNotice&) = delete;

private:
    std::jthread lines_; // of a pipe
};

} // namespace raysteps
