#include "program/show.h"

#include "basics/error.h"

namespace raysteps {

void show_in_window(WindowContext&, const Camera&, const std::filesystem::path&,
                    const RenderPicture&, LiveOffer) {
    throw MachineError("window: this program was built without GLFW. Install the package "
                       "libglfw3-dev, configure with -DRAYSTEPS_WINDOW=ON and build again.");
}

} // namespace raysteps
