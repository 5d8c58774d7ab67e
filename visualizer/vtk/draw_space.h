#pragma once

#include "drawing.h"

namespace raysteps::view {

// What is drawn in one pane.
struct SpaceInput {
    const Stage& stage;
    const State& state;
    std::size_t pane;
    const Shape& model;
    double distance; // of the eye from what it looks at
};

// The model, the structure's cells and the rays.
DrawnPane draw_space(vtkRenderer& renderer, const Area& area, const SpaceInput& input);

} // namespace raysteps::view
