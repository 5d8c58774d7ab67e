// GLFW: a window on a display.
#include "basics/error.h"
#include "gpu/context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>

namespace raysteps {

namespace {

std::string reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? std::string(" (") + text + ")" : std::string();
}

class GlfwContext final : public WindowContext {
public:
    GlfwContext(int width, int height, Visibility visibility) {
#ifdef GLFW_PLATFORM
        // GLFW 3.4 tries Wayland first, whose library complains where there is none.
        if (std::getenv("WAYLAND_DISPLAY") == nullptr && glfwPlatformSupported(GLFW_PLATFORM_X11)) {
            glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
        }
#endif
        if (!glfwInit()) {
            throw MachineError("window: no display can be opened" + reason() +
                               ". Start it on a desktop, or under xvfb-run, or leave out --window "
                               "and --context window.");
        }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, visibility == Visibility::shown ? GLFW_TRUE : GLFW_FALSE);
        window_ = glfwCreateWindow(width, height, "Raysteps", nullptr, nullptr);
        if (!window_) {
            const std::string why = reason();
            glfwTerminate();
            throw MachineError("window: the display gives no OpenGL 4.1 core context" + why +
                               ". Update the driver, or try --context osmesa.");
        }
        glfwMakeContextCurrent(window_);
        try {
            load_gl(glfwGetProcAddress, "window");
        } catch (...) {
            glfwTerminate();
            throw;
        }
    }

    ~GlfwContext() override {
        glfwTerminate();
    }
    GlfwContext(const GlfwContext&) = delete;
    GlfwContext& operator=(const GlfwContext&) = delete;

    GLFWwindow* window() const override {
        return window_;
    }

private:
    GLFWwindow* window_ = nullptr;
};

} // namespace

std::unique_ptr<WindowContext> make_window_context(int width, int height, Visibility visibility) {
    return std::make_unique<GlfwContext>(width, height, visibility);
}

} // namespace raysteps
