#include "basics/error.h"
#include "gpu/context.h"

namespace raysteps {

std::unique_ptr<WindowContext> make_window_context(int, int, Visibility) {
    throw MachineError("window: this program was built without GLFW. Install the package "
                       "libglfw3-dev, configure with -DRAYSTEPS_WINDOW=ON and build again.");
}

} // namespace raysteps
