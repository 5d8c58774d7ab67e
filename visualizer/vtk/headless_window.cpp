#include "headless_window.h"

#include "basics/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>

#include <array>
#include <string>

namespace raysteps::view {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw MachineError("egl: " + what +
                       ", so no picture can be drawn without a display. Install the packages "
                       "libegl-mesa0 and libgl1-mesa-dri, or start it on a display, such as "
                       "xvfb-run gives.");
}

// The one context that VTK draws with. It lives to the end of the program: VTK's static objects
// let go of OpenGL after everything else.
void make_context_current() {
    static bool made = false;
    if (made) {
        return;
    }
    const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platform_display) {
        fail("this EGL knows no platforms");
    }
    const EGLDisplay display =
        platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
        !eglBindAPI(EGL_OPENGL_API)) {
        fail("Mesa's platform without a surface cannot be had");
    }
    const std::array<EGLint, 13> wanted{EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_BIT,
                                        EGL_SURFACE_TYPE,
                                        EGL_PBUFFER_BIT,
                                        EGL_RED_SIZE,
                                        8,
                                        EGL_GREEN_SIZE,
                                        8,
                                        EGL_BLUE_SIZE,
                                        8,
                                        EGL_ALPHA_SIZE,
                                        8,
                                        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) {
        fail("no configuration has OpenGL");
    }
    const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        2,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
    const std::array<EGLint, 5> size{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size.data());
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, surface, surface, context)) {
        fail("there is no OpenGL 3.2");
    }
    // VTK goes on from the state in which it finds OpenGL, and counts on drawing over what is
    // there.
    constexpr unsigned less_or_equal = 0x0203; // GL_LEQUAL
    reinterpret_cast<void (*)(unsigned)>(eglGetProcAddress("glDepthFunc"))(less_or_equal);
    made = true;
}

// VTK's loader of functions looks for a display in vain and says so, but has found all functions by
// then. Other messages are to be seen.
class QuietWindow : public vtkGenericOpenGLRenderWindow {
public:
    static QuietWindow* New();
    vtkTypeMacro(QuietWindow, vtkGenericOpenGLRenderWindow)

protected:
    void OpenGLInitContext() override {
        const int shown = vtkObject::GetGlobalWarningDisplay();
        vtkObject::SetGlobalWarningDisplay(0);
        Superclass::OpenGLInitContext();
        vtkObject::SetGlobalWarningDisplay(shown);
    }
};

vtkStandardNewMacro(QuietWindow)

// VTK asks a generic window's owner whether its context is there.
void answer_yes(vtkObject*, unsigned long, void*, void* answer) {
    *static_cast<bool*>(answer) = true;
}

void answer_supported(vtkObject*, unsigned long, void*, void* answer) {
    *static_cast<int*>(answer) = 1;
}

void answer_on(vtkRenderWindow& window, unsigned long event,
               void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    window.AddObserver(event, command);
}

} // namespace

vtkSmartPointer<vtkRenderWindow> make_headless_window(const glm::ivec2& size) {
    make_context_current();
    vtkNew<QuietWindow> window;
    window->SetOwnContext(0);
    window->SetReadyForRendering(true);
    answer_on(*window, vtkCommand::WindowIsCurrentEvent, answer_yes);
    answer_on(*window, vtkCommand::WindowSupportsOpenGLEvent, answer_supported);
    window->SetOffScreenRendering(1);
    window->SetShowWindow(false);
    window->SetSize(size.x, size.y);
    return window;
}

} // namespace raysteps::view
