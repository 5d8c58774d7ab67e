// Stands in for vtk/ where VTK is missing.
#include "visualizer/show_view.h"

#include "basics/error.h"

namespace raysteps::view {

void show_view(const Request&, Stage&) {
    throw MachineError(
        "this program was built without VTK, which draws. Install it with `apt-get "
        "install --no-install-recommends libvtk9-dev libegl-dev libzip-dev`, and build again "
        "(`./run.sh view` does both).");
}

} // namespace raysteps::view
