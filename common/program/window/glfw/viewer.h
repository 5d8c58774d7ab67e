#pragma once

#include "program/window/coarseness.h"
#include "program/window/controls.h"
#include "program/window/frame.h"
#include "program/window/glfw/event_connection.h"
#include "program/window/screen.h"

#include <chrono>
#include <filesystem>
#include <optional>

namespace raysteps {

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
    std::chrono::steady_clock::time_point last_change_; // of what is wanted
    Frame frame_;
    std::optional<Texture> frame_texture_;
    int affordable_ = first_coarseness;
};

} // namespace raysteps
