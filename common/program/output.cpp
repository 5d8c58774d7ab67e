#include "program/output.h"

#include "basics/file.h"
#include "image/image_file.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <iostream>

namespace raysteps {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double seconds_between_lines = 0.25;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

void print_written(const std::filesystem::path& path) {
    std::cout << "wrote     " << path.string() << "\n" << std::flush;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    write_file(path, text);
    print_written(path);
}

void write_picture(const std::filesystem::path& path, const Image& image) {
    write_png(path, image);
    print_written(path);
}

std::string picture_name(const std::string& scene) {
    std::string name = std::filesystem::path(scene).stem().string();
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char letter) { return std::isalnum(letter) == 0 && letter != '-'; }, '_');
    return name;
}

std::function<void(double)> show_progress(const std::string& work) {
    if (isatty(STDERR_FILENO) == 0) {
        return [](double) {};
    }
    Clock::time_point started = Clock::now();
    Clock::time_point shown = started;
    bool visible = false;
    return [work, started, shown, visible](double part_done) mutable {
        if (part_done >= 1.0) {
            if (visible) {
                std::fprintf(stderr, "\r\033[K");
            }
            visible = false;
            started = Clock::now();
            return;
        }
        // Work that is done at once needs no line.
        if (seconds_since(shown) < seconds_between_lines || part_done <= 0.0) {
            return;
        }
        shown = Clock::now();
        visible = true;
        const double left = seconds_since(started) * (1.0 - part_done) / part_done;
        std::fprintf(stderr, "\r\033[K%s: %3.0f %%, %.0f s left", work.c_str(), 100.0 * part_done,
                     left);
        std::fflush(stderr);
    };
}

WorkNotice::WorkNotice(const std::string& work) {
    if (isatty(STDERR_FILENO) != 0) {
        std::fprintf(stderr, "%s ...", work.c_str());
        std::fflush(stderr);
    }
}

WorkNotice::~WorkNotice() {
    if (isatty(STDERR_FILENO) != 0) {
        std::fprintf(stderr, "\r\033[K");
    }
}

} // namespace raysteps
