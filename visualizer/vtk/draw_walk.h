#pragma once

#include "draw_space.h"

namespace raysteps::view {

// The rays of the path, and of the state's one what the walk did up to the state's step: where it
// is in the leaves, what it left out, what it tested and hit.
DrawnPane draw_path(vtkRenderer& renderer, const SpaceInput& input);

} // namespace raysteps::view
