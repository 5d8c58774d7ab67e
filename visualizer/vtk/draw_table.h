#pragma once

#include "visualizer/layout.h"
#include "visualizer/stage.h"

#include <vtkRenderer.h>

namespace raysteps::view {

// The cells of a structure in rows, sorted as the state says, the selected one marked.
void draw_table(vtkRenderer& renderer, const Layout& layout, const Pane& pane, const State& state);

} // namespace raysteps::view
