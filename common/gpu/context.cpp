#include "gpu/context.h"

#include "basics/error.h"
#include "gpu/gl.h"

#include <algorithm>
#include <array>

namespace raysteps {

namespace {

int living_contexts = 0;

std::unique_ptr<Context> make_automatic_context() {
    try {
        return make_egl_context(EglDevices::hardware_only);
    } catch (const MachineError&) {
        // Usually there is no such GPU, and that is not an error.
        return make_osmesa_context();
    }
}

} // namespace

std::unique_ptr<Context> make_context(ContextKind kind) {
    switch (kind) {
    case ContextKind::osmesa:
        return make_osmesa_context();
    case ContextKind::egl:
        return make_egl_context(EglDevices::any);
    case ContextKind::window:
        return make_window_context(64, 64, Visibility::hidden);
    case ContextKind::automatic:
        break;
    }
    return make_automatic_context();
}

Context::Context() {
    ++living_contexts;
}

Context::~Context() {
    --living_contexts;
}

std::optional<OpenGl> current_opengl() {
    if (living_contexts == 0) {
        return std::nullopt;
    }
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value ? std::string(reinterpret_cast<const char*>(value)) : std::string("unknown");
    };
    return OpenGl{text(GL_RENDERER), text(GL_VERSION)};
}

std::string renderer_name() {
    const OpenGl opengl = current_opengl().value();
    return opengl.renderer + ", OpenGL " + opengl.version;
}

bool runs_on_processor(const std::string& renderer) {
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "SWR"}, [&](const char* name) {
        return renderer.find(name) != std::string::npos;
    });
}

void load_gl(FindGlFunction find, const std::string& provider) {
    const int version = gladLoadGL(find);
    if (version == 0) {
        throw MachineError(provider + ": OpenGL could not be loaded. Install a driver, or try "
                                      "--context osmesa.");
    }
    if (version < GLAD_MAKE_VERSION(4, 1)) {
        throw MachineError(provider + ": OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) +
                           "." + std::to_string(GLAD_VERSION_MINOR(version)) +
                           " is too old, 4.1 is needed. Update the driver, or try --context "
                           "osmesa.");
    }
}

} // namespace raysteps
