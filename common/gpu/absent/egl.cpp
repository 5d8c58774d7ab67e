#include "basics/error.h"
#include "gpu/context.h"

namespace raysteps {

std::unique_ptr<Context> make_egl_context(EglDevices) {
    throw MachineError("egl: this program was built without EGL. Install the package libegl-dev "
                       "and build again, or try --context osmesa.");
}

} // namespace raysteps
