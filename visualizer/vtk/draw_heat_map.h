#pragma once

#include "visualizer/layout.h"
#include "visualizer/stage.h"

#include <vtkRenderer.h>

namespace raysteps::view {

// How much work each pixel of the traced picture is, as a picture, with the numbers of its colours
// and how many pixels there are of each.
void draw_heat_map(vtkRenderer& renderer, const Area& area, const Stage& stage, const State& state,
                   std::size_t pane);

} // namespace raysteps::view
