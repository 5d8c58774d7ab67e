#pragma once

#include "visualizer/layout.h"
#include "visualizer/stage.h"

#include <vtkRenderer.h>

namespace raysteps::view {

// The steps: a slider with a mark for each, the sentence of the state's step in each pane, the line
// of the shader that decides it, and where walks part.
void draw_bottom(vtkRenderer& renderer, const Layout& layout, const Stage& stage,
                 const State& state);

} // namespace raysteps::view
