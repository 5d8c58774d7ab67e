#pragma once

#include "layout.h"
#include "stage.h"

#include <optional>

namespace raysteps::view {

// The state after a click at that place, or a drag to it, with the left button: on a slider, the
// table or a heat map. The same state where there is nothing to click on.
State after_click(const State& state, const Stage& stage, const glm::ivec2& place);

// Whether a drag from that place moves a slider instead of the camera.
bool is_on_panel(const State& state, const Stage& stage, const glm::ivec2& place);

// The state with that cell marked in space and in the table, which scrolls to its row.
State with_selected(const State& state, const Stage& stage, int cell);

// The state with the camera's ray to that point of the model.
State with_ray_to(const State& state, const Stage& stage, const glm::vec3& point);

// The state that asks why the walk does not come to the triangle under that place of a pane, which
// the loop over every triangle finds; the same state where there is none, or no ray.
State with_why_at(const State& state, const Stage& stage, const Camera& viewpoint,
                  const glm::ivec2& place);

// Where the ray from the viewpoint through that place of a pane meets the model; nothing where it
// does not.
std::optional<glm::vec3> point_under(const State& state, const Stage& stage,
                                     const Camera& viewpoint, const glm::ivec2& place);

// The smallest drawn cell that the ray from the viewpoint through that place meets; no_cell where
// there is none.
int cell_under(const State& state, const Stage& stage, const Camera& viewpoint,
               const glm::ivec2& place);

} // namespace raysteps::view
