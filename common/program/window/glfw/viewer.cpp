#include "program/window/glfw/viewer.h"

#include "basics/error.h"
#include "image/image_file.h"
#include "scene/camera_text.h"
#include "program/window/help_picture.h"
#include "program/window/screenshot_path.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <utility>

namespace raysteps {

namespace {

using Clock = std::chrono::steady_clock;

constexpr float help_opacity = 0.85f;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// How much larger than pixel for pixel the desktop wants text to be.
double text_scale(GLFWwindow* window) {
    float horizontal = 1.0f;
    float vertical = 1.0f;
    glfwGetWindowContentScale(window, &horizontal, &vertical);
    return std::max(1.0, static_cast<double>(std::round(horizontal)));
}

} // namespace

Viewer::Viewer(GLFWwindow* window, const Camera& start, const std::filesystem::path& screenshot,
               const RenderPicture& render)
    : window_(window), screenshot_(screenshot), render_(render), controls_(start_controls(start)),
      connection_(window, controls_), help_(help_picture()), help_texture_(screen_texture(help_)) {
    write_title();
    look_what_is_wanted();
}

void Viewer::run() {
    while (!controls_.close) {
        wait_for_events();
        look_what_is_wanted();
        save_picture();
        print_camera();
        refine_picture();
        redraw();
    }
}

void Viewer::wait_for_events() const {
    const double seconds = seconds_to_wait();
    if (seconds == 0.0) {
        glfwPollEvents();
    } else if (std::isinf(seconds)) {
        glfwWaitEvents();
    } else {
        glfwWaitEventsTimeout(seconds);
    }
}

void Viewer::look_what_is_wanted() {
    Sight sight{.camera = controls_.camera};
    glfwGetFramebufferSize(window_, &sight.width, &sight.height);
    if (!same_sight(sight, wanted_)) {
        wanted_ = sight;
        last_change_ = Clock::now();
    }
}

void Viewer::save_picture() {
    if (!controls_.camera_to_save || is_empty(wanted_)) {
        return;
    }
    Sight sight = wanted_;
    sight.camera = *std::exchange(controls_.camera_to_save, std::nullopt);
    if (frame_.coarseness != 1 || !same_sight(frame_.sight, sight)) {
        take(render_frame(render_, sight, 1));
    }
    const std::filesystem::path path = screenshot_path(screenshot_);
    try {
        write_png(path, frame_.image);
        std::cout << "wrote     " << path.string() << "\n" << std::flush;
    } catch (const InputError& error) {
        // The picture is not lost: the window goes on, and S can be pressed again.
        std::cerr << error.what() << "\n";
    }
}

void Viewer::print_camera() {
    if (controls_.camera_to_print) {
        const Camera camera = *std::exchange(controls_.camera_to_print, std::nullopt);
        std::cout << "camera    " << camera_text(camera, controls_.start.up) << "\n" << std::flush;
    }
}

void Viewer::refine_picture() {
    if (!controls_.close && seconds_to_wait() == 0.0) {
        take(render_frame(render_, wanted_, next_coarseness(shown_coarseness(), affordable_)));
    }
}

void Viewer::redraw() {
    if (!controls_.must_redraw || is_empty(wanted_) || !frame_texture_) {
        return;
    }
    controls_.must_redraw = false;
    screen_.draw(*frame_texture_, {.width = wanted_.width, .height = wanted_.height}, 1.0f);
    if (controls_.help) {
        const ScreenPlace place =
            overlay_place(help_, text_scale(window_), wanted_.width, wanted_.height);
        screen_.draw(help_texture_, place, help_opacity);
    }
    glfwSwapBuffers(window_);
}

int Viewer::shown_coarseness() const {
    return same_sight(frame_.sight, wanted_) ? frame_.coarseness : 0;
}

double Viewer::seconds_to_wait() const {
    if (is_empty(wanted_)) {
        return std::numeric_limits<double>::infinity();
    }
    return wait_before_frame(shown_coarseness(), seconds_since(last_change_));
}

void Viewer::take(Frame frame) {
    frame_ = std::move(frame);
    frame_texture_ = screen_texture(frame_.image);
    affordable_ = affordable_coarseness(frame_.coarseness, frame_.seconds);
    controls_.must_redraw = true;
    if (frame_.coarseness == 1) {
        write_title();
    }
}

// The size and the time of the last full picture.
void Viewer::write_title() {
    std::ostringstream title;
    title << "Raysteps: " << screenshot_.filename().string();
    if (frame_.coarseness == 1) {
        title << ", " << frame_.sight.width << " x " << frame_.sight.height << ", "
              << std::lround(1000.0 * frame_.seconds) << " ms";
    }
    title << " (H shows the keys)";
    glfwSetWindowTitle(window_, title.str().c_str());
}

} // namespace raysteps
