#include "display.h"

#include <X11/Xlib.h>

#include <memory>

namespace raysteps::view {

bool has_display() {
    // Stays open: an X server resets itself when its last client leaves, and would not be there for
    // the window that comes next.
    static const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr),
                                                                     XCloseDisplay);
    return display != nullptr;
}

} // namespace raysteps::view
