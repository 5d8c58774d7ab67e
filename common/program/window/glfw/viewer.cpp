#include "basics/error.h"
#include "image/image_file.h"
#include "program/show.h"
#include "program/window/controls.h"
#include "program/window/panel.h"
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
#include <vector>

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

void on_key(GLFWwindow* window, int key, int scan_code, int action, int modifiers) {
    // A key that is held down repeats itself, which no key here is meant to do.
    if (action != GLFW_PRESS) {
        return;
    }
    Controls& controls = controls_of(window);
    if (key == GLFW_KEY_ESCAPE) {
        controls = press_key(controls, 'q');
        return;
    }
    if (key == GLFW_KEY_F5) {
        controls.read_shaders = true;
        return;
    }
    // GLFW numbers keys by their place on an American keyboard; the name is what is printed on it.
    if (const char* name = glfwGetKeyName(key, scan_code)) {
        controls = press_key(controls, name[0], (modifiers & GLFW_MOD_SHIFT) != 0);
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
           const RenderPicture& render, LiveOffer offer);

    // Until the window is closed.
    void run();

private:
    void wait_for_events() const;
    void look_what_is_wanted();
    void follow_keys();
    void take_word(std::size_t choice, std::size_t word);
    void take_next_word(LiveChoice& choice, bool backwards);
    bool try_change(const std::string& what, const std::function<void()>& change);
    void read_shaders();
    void name_clicked_pixel();
    void refine_picture();
    void save_picture();
    void print_camera();
    void redraw();
    void draw_panel();

    int shown_coarseness() const;
    double seconds_to_wait() const;
    void take(Frame frame);
    void write_title();

    GLFWwindow* window_;
    std::filesystem::path screenshot_;
    const RenderPicture& render_;
    LiveOffer offer_;
    Controls controls_;
    EventConnection connection_;
    Screen screen_;
    std::optional<Panel> panel_; // once it was asked for
    std::vector<float> milliseconds_;
    std::string problem_; // that the panel shows
    std::string command_;
    Sight wanted_;
    Clock::time_point last_change_; // of what is wanted
    Frame frame_;
    std::optional<Texture> frame_texture_;
    int affordable_ = first_coarseness;
    bool has_failed_ = false; // to render what is wanted
    bool is_asked_ = false;   // by the panel, for something to be done before events come
};

constexpr std::size_t most_milliseconds = 120; // of the panel's plot

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
               const RenderPicture& render, LiveOffer offer)
    : window_(window), screenshot_(screenshot), render_(render), offer_(std::move(offer)),
      controls_(start_controls(start)), connection_(window, controls_) {
    write_title();
    look_what_is_wanted();
}

void Viewer::run() {
    while (!controls_.close) {
        wait_for_events();
        look_what_is_wanted();
        follow_keys();
        save_picture();
        print_camera();
        refine_picture();
        redraw();
    }
}

void Viewer::wait_for_events() const {
    const double seconds = is_asked_ ? 0.0 : seconds_to_wait();
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

// A letter that takes the next word of a choice.
void Viewer::follow_keys() {
    for (const ChoiceKey& key : std::exchange(controls_.choice_keys, {})) {
        for (LiveChoice& choice : offer_.choices) {
            if (choice.key == key.letter) {
                take_next_word(choice, key.shift);
            }
        }
    }
    if (std::exchange(controls_.read_shaders, false)) {
        read_shaders();
    }
    name_clicked_pixel();
}

// The one after it, where that cannot be.
void Viewer::take_next_word(LiveChoice& choice, bool backwards) {
    const auto number = static_cast<std::size_t>(&choice - offer_.choices.data());
    const std::size_t count = choice.words.size();
    const std::size_t before = choice.chosen;
    std::size_t word = before;
    do {
        word = (word + (backwards ? count - 1 : 1)) % count;
        take_word(number, word);
    } while (choice.chosen == before && word != before);
}

void Viewer::take_word(std::size_t number, std::size_t word) {
    LiveChoice& choice = offer_.choices[number];
    const std::string& name = choice.words[word];
    if (try_change(choice.name + " " + name, [&] { choice.take(name); })) {
        choice.chosen = word;
    }
}

// Where a change cannot be made, the window says so and stays as it is.
bool Viewer::try_change(const std::string& what, const std::function<void()>& change) {
    controls_.must_redraw = true;
    try {
        change();
    } catch (const Error& error) {
        problem_ = error.what();
        std::cerr << problem_ << "\n";
        return false;
    }
    std::cout << "now       " << what << "\n" << std::flush;
    problem_.clear();
    milliseconds_.clear();
    frame_.coarseness = 0;
    affordable_ = first_coarseness;
    return true;
}

void Viewer::read_shaders() {
    if (offer_.read_shaders) {
        try_change("with the shaders as they are now", offer_.read_shaders);
    }
}

// Prints the command that shows the clicked pixel's ray, and copies it for other windows.
void Viewer::name_clicked_pixel() {
    const std::optional<glm::dvec2> place = std::exchange(controls_.clicked, std::nullopt);
    if (!place || !offer_.view_command || is_empty(wanted_)) {
        return;
    }
    // A heat map's picture has a legend below.
    const glm::dvec2 part = *place / glm::max(controls_.window_size, glm::dvec2(1.0));
    const double rows = frame_.coarseness == 1 ? frame_.image.height : wanted_.height;
    const SeenPixel pixel{wanted_.camera, wanted_.width, wanted_.height,
                          static_cast<int>(part.x * wanted_.width),
                          static_cast<int>(part.y * rows)};
    if (pixel.column < 0 || pixel.row < 0 || pixel.column >= pixel.width ||
        pixel.row >= pixel.height) {
        return;
    }
    command_ = offer_.view_command(pixel);
    glfwSetClipboardString(window_, command_.c_str());
    std::cout << "view      " << command_ << "\n" << std::flush;
    controls_.must_redraw = true;
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
    if (has_failed_) {
        std::cerr << problem_ << "\n";
        return;
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
        const int coarseness = next_coarseness(shown_coarseness(), affordable_);
        if (!offer_.read_shaders) {
            take(render_frame(render_, wanted_, coarseness));
            return;
        }
        // A shader that does not compile is told where it is used first: the last picture stays.
        try {
            take(render_frame(render_, wanted_, coarseness));
        } catch (const Error& error) {
            problem_ = error.what();
            std::cerr << problem_ << "\n";
            frame_.sight = wanted_;
            frame_.coarseness = 1;
            has_failed_ = true;
            controls_.must_redraw = true;
        }
    }
}

void Viewer::redraw() {
    if (!controls_.must_redraw || is_empty(wanted_) || !frame_texture_) {
        return;
    }
    controls_.must_redraw = false;
    is_asked_ = false;
    screen_.draw(*frame_texture_, wanted_.width, wanted_.height);
    if (controls_.help) {
        draw_panel();
    }
    glfwSwapBuffers(window_);
}

void Viewer::draw_panel() {
    if (!panel_) {
        panel_.emplace(text_scale(window_));
    }
    const PanelContent content{.choices = offer_.choices,
                               .reads_shaders = static_cast<bool>(offer_.read_shaders),
                               .milliseconds = milliseconds_,
                               .notes = offer_.notes ? offer_.notes() : std::vector<std::string>{},
                               .problem = problem_,
                               .command = command_};
    const PanelWishes wishes = panel_->draw(content, std::exchange(controls_.panel_events, {}),
                                            glm::max(controls_.window_size, glm::dvec2(1.0)),
                                            {wanted_.width, wanted_.height});
    controls_.panel = panel_->covered();
    for (const PanelWishes::Word& wish : wishes.words) {
        take_word(wish.choice, wish.word);
    }
    for (const char letter : wishes.letters) {
        controls_ = press_key(controls_, letter);
    }
    controls_.read_shaders = controls_.read_shaders || wishes.read_shaders;
    is_asked_ = !wishes.words.empty() || !wishes.letters.empty() || wishes.read_shaders;
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
    has_failed_ = false;
    frame_texture_ = screen_texture(frame_.image);
    affordable_ = affordable_coarseness(frame_.coarseness, frame_.seconds);
    if (milliseconds_.size() == most_milliseconds) {
        milliseconds_.erase(milliseconds_.begin());
    }
    milliseconds_.push_back(
        static_cast<float>(1000.0 * frame_.seconds * frame_.coarseness * frame_.coarseness));
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
                    const std::filesystem::path& screenshot, const RenderPicture& render,
                    LiveOffer offer) {
    Viewer(context.window(), start, screenshot, render, std::move(offer)).run();
}

} // namespace raysteps
