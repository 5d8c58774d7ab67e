#pragma once

#include "visualizer/stage.h"

namespace raysteps::view {

// A small state with a ray that hits: one of the balls in the scene of mirrors.
inline State mirrors_state(const std::string& structure = "bvh_ordered") {
    State state;
    state.scene = "mirrors";
    state.structures = {structure};
    state.picture = {64, 64};
    state.pixel = glm::ivec2(25, 38);
    state.filter = CellFilter::visited;
    return state;
}

} // namespace raysteps::view
