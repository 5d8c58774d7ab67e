// The loader's own code is here, in one source.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpedantic"
#endif
#define GLAD_GL_IMPLEMENTATION
#include "gpu/gl.h"

#include "basics/error.h"

#include <fmt/core.h>

namespace raysteps {

void check_gl(const std::string& doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) {
        return;
    }
    clear_gl_errors();
    if (error == GL_OUT_OF_MEMORY) {
        throw MachineError("OpenGL ran out of memory while " + doing +
                           ". Take a smaller scene or a smaller --size.");
    }
    throw MachineError(
        fmt::format("OpenGL reported the error 0x{:04X} while ", error) + doing +
        ". Try --context osmesa; if it persists, this is a bug in Raysteps; please report it.");
}

void clear_gl_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

} // namespace raysteps
