// Ends with 0 if the context of the given kind is an OpenGL 4.1 core context or a later one.
#include "basics/error.h"
#include "gpu/context.h"
#include "gpu/gl.h"
#include "program/options.h"

#include <cstdio>

using namespace raysteps;

namespace {

int number_of(GLenum name) {
    GLint number = 0;
    glGetIntegerv(name, &number);
    return number;
}

void check_core_context() {
    const int major = number_of(GL_MAJOR_VERSION);
    const int minor = number_of(GL_MINOR_VERSION);
    std::printf("%s\n", renderer_name().c_str());
    if (major < 4 || (major == 4 && minor < 1)) {
        throw Error(ExitCode::check_failed, "The version is below 4.1. See common/gpu/context.");
    }
    if ((number_of(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) == 0) {
        throw Error(ExitCode::check_failed, "It is no core profile. See common/gpu/context.");
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto context = make_context(parse_context(argc == 2 ? argv[1] : ""));
        check_core_context();
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "core_context: %s\n", error.what());
        return static_cast<int>(error.code());
    }
}
