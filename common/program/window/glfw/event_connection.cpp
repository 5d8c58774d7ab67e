#include "program/window/glfw/event_connection.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <optional>

namespace raysteps {

namespace {

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

} // namespace

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

} // namespace raysteps
