// EGL without a surface: OpenGL on a GPU that no display is attached to, or Mesa on the processor.
#include "basics/error.h"
#include "gpu/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <string_view>
#include <vector>

namespace raysteps {

namespace {

bool has_word(const char* words, std::string_view word) {
    return words && std::string_view(words).find(word) != std::string_view::npos;
}

template <class Function>
Function find_egl(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// The displays to try, the hardware's first.
std::vector<EGLDisplay> list_displays(EglDevices devices) {
    const auto query_devices = find_egl<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_string = find_egl<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    const auto platform_display =
        find_egl<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    std::vector<EGLDisplay> displays;
    if (!platform_display) {
        return displays;
    }
    std::array<EGLDeviceEXT, 16> found{};
    EGLint count = 0;
    if (query_devices && query_string &&
        query_devices(static_cast<EGLint>(found.size()), found.data(), &count)) {
        for (EGLint i = 0; i < count; ++i) {
            const char* extensions = query_string(found[i], EGL_EXTENSIONS);
            if (!has_word(extensions, "EGL_MESA_device_software")) {
                displays.push_back(platform_display(EGL_PLATFORM_DEVICE_EXT, found[i], nullptr));
            }
        }
    }
    const char* client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (devices == EglDevices::any &&
        has_word(client_extensions, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    return displays;
}

EGLContext make_core_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                       EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        1,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

// Some drivers offer a processor as a device without calling it software.
bool runs_on_processor() {
    const std::string renderer = renderer_name();
    return has_word(renderer.c_str(), "llvmpipe") || has_word(renderer.c_str(), "softpipe") ||
           has_word(renderer.c_str(), "swrast");
}

class EglContext final : public Context {
public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}

    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

private:
    EGLDisplay display_;
    EGLContext context_;
};

} // namespace

std::unique_ptr<Context> make_egl_context(EglDevices devices) {
    for (EGLDisplay display : list_displays(devices)) {
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
            continue;
        }
        EGLContext context = make_core_context(display);
        if (context == EGL_NO_CONTEXT) {
            eglTerminate(display);
            continue;
        }
        auto made = std::make_unique<EglContext>(display, context);
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
            continue;
        }
        try {
            load_gl(eglGetProcAddress, "egl");
        } catch (const MachineError&) {
            continue; // the next device may do better
        }
        if (devices == EglDevices::hardware_only && runs_on_processor()) {
            continue;
        }
        return made;
    }
    if (devices == EglDevices::hardware_only) {
        throw MachineError("egl: no hardware GPU with OpenGL 4.1 was found. Try --context osmesa.");
    }
    throw MachineError("egl: no device gives an OpenGL 4.1 core context. Install a GPU driver or "
                       "the packages libegl-mesa0 and libgl1-mesa-dri, or try --context osmesa.");
}

} // namespace raysteps
