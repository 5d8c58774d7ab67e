#include "window.h"

#include "basics/error.h"
#include "image/color.h"
#include "image/image_file.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <X11/Xlib.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <memory>
#include <string>

namespace raysteps::view {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw MachineError("egl: " + what +
                       ", so no picture can be drawn without a display. Install the packages "
                       "libegl-mesa0 and libgl1-mesa-dri, or run it on a display, such as one "
                       "from xvfb-run.");
}

// The one context that VTK draws with. It lives to the end of the program: VTK's static objects
// release OpenGL after everything else.
void make_context_current() {
    static bool made = false;
    if (made) {
        return;
    }
    const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platform_display) {
        fail("this EGL does not support platforms");
    }
    const EGLDisplay display =
        platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
        !eglBindAPI(EGL_OPENGL_API)) {
        fail("Mesa's surfaceless platform is not available");
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
        fail("no configuration supports OpenGL");
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
    // VTK starts from the OpenGL state that it finds, and relies on drawing over what is there.
    constexpr unsigned less_or_equal = 0x0203; // GL_LEQUAL
    reinterpret_cast<void (*)(unsigned)>(eglGetProcAddress("glDepthFunc"))(less_or_equal);
    made = true;
}

// VTK's function loader looks for a display in vain and reports that, but by then it has found all
// functions. Other messages are shown.
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

// VTK asks the owner of a generic window whether its context exists.
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

bool has_display() {
    // Stays open: an X server resets itself when its last client leaves, and would not accept the
    // window that comes next.
    static const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr),
                                                                     XCloseDisplay);
    return display != nullptr;
}

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

Image picture_of(vtkRenderWindow& window) {
    window.Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(&window);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->ShouldRerenderOff();
    filter->Update();
    vtkImageData& pixels = *filter->GetOutput();
    const int* const size = pixels.GetDimensions();
    Image image(size[0], size[1]);
    for (int row = 0; row < size[1]; ++row) {
        for (int column = 0; column < size[0]; ++column) {
            const auto* const texel = static_cast<const unsigned char*>(
                pixels.GetScalarPointer(column, size[1] - 1 - row, 0));
            for (int i = 0; i < 3; ++i) {
                image.at(column, row)[i] = linear_from_srgb(static_cast<float>(texel[i]) / 255.0f);
            }
        }
    }
    return image;
}

void write_screenshot(vtkRenderWindow& window, const std::filesystem::path& path) {
    write_png(path, picture_of(window));
}

} // namespace raysteps::view
