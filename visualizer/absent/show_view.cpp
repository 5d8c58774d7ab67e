// Stands in for vtk/ where VTK is missing.
#include "visualizer/request.h"

#include "basics/error.h"

namespace raysteps::view {

void show_view(const Request&, Stage&) {
    throw MachineError(
        "this program was built without VTK, which it needs to draw. Install VTK with `apt-get "
        "install --no-install-recommends libvtk9-dev libegl-dev libzip-dev`, and rebuild "
        "(`./run.sh view` does both).");
}

} // namespace raysteps::view
