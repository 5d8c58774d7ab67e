#pragma once

#include "visualizer/request.h"
#include "visualizer/stage.h"

#include <filesystem>

namespace raysteps::view {

// Opens a window on the state, and returns when it is closed. There has to be a display.
void show_in_window(const Request& request, Stage& stage);

// A name for pictures of the state: out/view/bunny_bvh_ordered.png.
std::filesystem::path picture_path(const State& state);

} // namespace raysteps::view
