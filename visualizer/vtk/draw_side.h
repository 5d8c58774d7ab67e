#pragma once

#include "visualizer/layout.h"
#include "visualizer/stage.h"
#include "drawing.h"

namespace raysteps::view {

// What the colours mean, with numbers; the facts of the structures, or the table of the first one's
// cells; and two sliders.
void draw_side(vtkRenderer& renderer, const Layout& layout, const Stage& stage, const State& state,
               const std::vector<DrawnPane>& drawn);

} // namespace raysteps::view
