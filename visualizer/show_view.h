#pragma once

#include "request.h"
#include "stage.h"

namespace raysteps::view {

// Does what is asked for: writes pictures and files, or opens a window. The stage shows the
// request's state. Throws MachineError where the machine can draw nothing.
void show_view(const Request& request, Stage& stage);

} // namespace raysteps::view
