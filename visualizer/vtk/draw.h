#pragma once

#include "drawing.h"

// What a drawing is put together from, each in its own renderer.
namespace raysteps::view {

// What is drawn in one pane.
struct SpaceInput {
    const Stage& stage;
    const State& state;
    std::size_t pane;
    const Shape& model;
    glm::vec3 eye;
    double distance; // from the eye to what it looks at
};

// The model, the structure's cells and the rays.
DrawnPane draw_space(vtkRenderer& renderer, const Area& area, const SpaceInput& input);

// The rays of the path, and what the walk of the state's ray has done by the state's step: where it
// is in the leaves, what it left out, what it tested and hit.
DrawnPane draw_path(vtkRenderer& renderer, const SpaceInput& input);

// The work of each pixel of the traced picture, as a picture, with a histogram of its colours.
void draw_heat_map(vtkRenderer& renderer, const Area& area, const Stage& stage, const State& state,
                   std::size_t pane);

// What the colours mean, with numbers; the facts of the structures, or the table of the first one's
// cells; and two sliders.
void draw_side(vtkRenderer& renderer, const Layout& layout, const Stage& stage, const State& state,
               const std::vector<DrawnPane>& drawn);

// The steps: a slider with a mark for each, the sentence of the state's step in each pane, the line
// of the shader that decides it, and where walks part.
void draw_bottom(vtkRenderer& renderer, const Layout& layout, const Stage& stage,
                 const State& state);

} // namespace raysteps::view
