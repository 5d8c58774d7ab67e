#include "program/output.h"

#include "basics/file.h"
#include "image/image_file.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <iostream>
#include <mutex>

namespace raysteps {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double seconds_between_lines = 0.25;
constexpr double seconds_between_lines_in_pipe = 10.0;

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

namespace {

bool is_on_terminal() {
    return isatty(STDERR_FILENO) != 0;
}

} // namespace

std::function<void(double)> show_progress(const std::string& work) {
    const bool on_terminal = is_on_terminal();
    const double pause = on_terminal ? seconds_between_lines : seconds_between_lines_in_pipe;
    Clock::time_point started = Clock::now();
    Clock::time_point shown = started;
    bool visible = false;
    return [=](double part_done) mutable {
        if (part_done >= 1.0) {
            if (visible) {
                std::fprintf(stderr, "\r\033[K");
            }
            visible = false;
            started = Clock::now();
            shown = started;
            return;
        }
        // Work that is done at once needs no line.
        if (seconds_since(shown) < pause || part_done <= 0.0) {
            return;
        }
        shown = Clock::now();
        visible = on_terminal;
        const double left = seconds_since(started) * (1.0 - part_done) / part_done;
        std::fprintf(stderr, "%s%s: %3.0f %%, %.0f s left%s", on_terminal ? "\r\033[K" : "",
                     work.c_str(), 100.0 * part_done, left, on_terminal ? "" : "\n");
        std::fflush(stderr);
    };
}

WorkNotice::WorkNotice(const std::string& work) {
    if (is_on_terminal()) {
        std::fprintf(stderr, "%s ...", work.c_str());
        std::fflush(stderr);
        return;
    }
    const Clock::time_point started = Clock::now();
    lines_ = std::jthread([work, started](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any ends;
        std::unique_lock lock(mutex);
        const std::chrono::duration<double> pause(seconds_between_lines_in_pipe);
        while (!ends.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); })) {
            std::fprintf(stderr, "%s: %.0f s so far\n", work.c_str(), seconds_since(started));
            std::fflush(stderr);
        }
    });
}

WorkNotice::~WorkNotice() {
    if (is_on_terminal()) {
        std::fprintf(stderr, "\r\033[K");
    }
}

} // namespace raysteps
