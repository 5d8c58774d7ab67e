#include "visualizer/vtk/display.h"

#include <X11/Xlib.h>

namespace raysteps::view {

bool has_display() {
    Display* const display = XOpenDisplay(nullptr);
    if (!display) {
        return false;
    }
    XCloseDisplay(display);
    return true;
}

} // namespace raysteps::view
