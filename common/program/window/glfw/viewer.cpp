#include "basics/error.h"
#include "image/image_file.h"
#include "program/show.h"
#include "program/window/controls.h"
#include "program/window/screen.h"
#include "scene/camera_text.h"

#include <fmt/core.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <utility>

namespace raysteps {

namespace {

using Clock = std::chrono::steady_clock;

Controls& controls_of(GLFWwindow* window) {
    return *static_cast<Controls*>(glfwGetWindowUserPointer(window));
}

std::optional<Button> button_of(int button) {
    switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
        return Button::left;
    case GLFW_MOUSE_BUTTON_MIDDLE:
        return Button::middle;
    case GLFW_MOUSE_BUTTON_RIGHT:
        return Button::right;
    default:
        return std::nullopt;
    }
}

void on_button(GLFWwindow* window, int number, int action, int modifiers) {
    const std::optional<Button> button = button_of(number);
    if (!button) {
        return;
    }
    Controls& controls = controls_of(window);
    if (action == GLFW_PRESS) {
        controls = press_button(controls, *button,
                                {.shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                 .control = (modifiers & GLFW_MOD_CONTROL) != 0});
    } else {
        controls = release_button(controls, *button);
    }
}

void on_cursor(GLFWwindow* window, double x, double y) {
    Controls& controls = controls_of(window);
    controls = move_cursor(controls, {x, y});
}

void on_scroll(GLFWwindow* window, double, double notches) {
    Controls& controls = controls_of(window);
    controls = scroll(controls, notches);
}

void on_key(GLFWwindow* window, int key, int scan_code, int action, int) {
    // A key that is held down repeats itself, which no key here is meant to do.
    if (action != GLFW_PRESS) {
        return;
    }
    Controls& controls = controls_of(window);
    if (key == GLFW_KEY_ESCAPE) {
        controls = press_key(controls, 'q');
        return;
    }
    // GLFW numbers keys by their place on an American keyboard; the name is what is printed on it.
    if (const char* name = glfwGetKeyName(key, scan_code)) {
        controls = press_key(controls, name[0]);
    }
}

void on_close(GLFWwindow* window) {
    controls_of(window).close = true;
}

void on_refresh(GLFWwindow* window) {
    controls_of(window).must_redraw = true;
}

void on_window_size(GLFWwindow* window, int width, int height) {
    controls_of(window).window_size = {width, height};
}

void on_framebuffer_size(GLFWwindow* window, int, int) {
    controls_of(window).must_redraw = true;
}

// From its making to its end, the window's events change the controls.
class EventConnection {
public:
    EventConnection(GLFWwindow* window, Controls& controls);
    ~EventConnection();
    EventConnection(const EventConnection&) = delete;
    EventConnection& operator=(const EventConnection&) = delete;

private:
    GLFWwindow* window_;
};

EventConnection::EventConnection(GLFWwindow* window, Controls& controls) : window_(window) {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window, &width, &height);
    controls.window_size = {width, height};
    glfwGetCursorPos(window, &controls.cursor.x, &controls.cursor.y);
    glfwSetWindowUserPointer(window, &controls);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetKeyCallback(window, on_key);
    glfwSetWindowCloseCallback(window, on_close);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetWindowSizeCallback(window, on_window_size);
    glfwSetFramebufferSizeCallback(window, on_framebuffer_size);
}

EventConnection::~EventConnection() {
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetKeyCallback(window_, nullptr);
    glfwSetWindowCloseCallback(window_, nullptr);
    glfwSetWindowRefreshCallback(window_, nullptr);
    glfwSetWindowSizeCallback(window_, nullptr);
    glfwSetFramebufferSizeCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

// The picture in a window, and the loop that keeps it up with the events.
class Viewer {
public:
    Viewer(GLFWwindow* window, const Camera& start, const std::filesystem::path& screenshot,
           const RenderPicture& render);

    // Until the window is closed.
    void run();

private:
    void wait_for_events() const;
    void look_what_is_wanted();
    void refine_picture();
    void save_picture();
    void print_camera();
    void redraw();

    int shown_coarseness() const;
    double seconds_to_wait() const;
    void take(Frame frame);
    void write_title();

    GLFWwindow* window_;
    std::filesystem::path screenshot_;
    const RenderPicture& render_;
    Controls controls_;
    EventConnection connection_;
    Screen screen_;
    Image help_;
    Texture help_texture_;
    Sight wanted_;
    Clock::time_point last_change_; // of what is wanted
    Frame frame_;
    std::optional<Texture> frame_texture_;
    int affordable_ = first_coarseness;
};

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
    std::string title = "Raysteps: " + screenshot_.filename().string();
    if (frame_.coarseness == 1) {
        title += fmt::format(", {} x {}, {} ms", frame_.sight.width, frame_.sight.height,
                             std::lround(1000.0 * frame_.seconds));
    }
    glfwSetWindowTitle(window_, (title + " (H shows the keys)").c_str());
}

} // namespace

void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render) {
    Viewer(context.window(), start, screenshot, render).run();
}

} // namespace raysteps
