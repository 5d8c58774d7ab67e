#pragma once

#include "scene/mesh.h"
#include "scene/random_numbers.h"

namespace raysteps {

// Meshes that lie across the cells of a grid or the leaves of a kd-tree, or in their very planes.

// Triangle 0 is listed in the first of four cells along x and hit in the fourth; triangle 1 lies
// between, and is nearer for a ray along x through (0, 0.5, 0.5).
Mesh long_triangle_before_a_small_one();

// The same among clutter, for trees: the small triangle, 1, is around that point.
struct LongAndSmall {
    Mesh mesh;
    glm::vec3 small{0.0f};
};
LongAndSmall long_triangle_before_a_small_one_among_clutter(RandomNumbers& numbers);

// Five walls of squares upright on each axis, at whole coordinates from 0 to 4: every good plane of
// a kd-tree is one of theirs.
Mesh walls_at_whole_coordinates();

// Loose triangles, and behind them a wall at x = 0, 80 wide and high, of two triangles that share
// the edge y = z.
Mesh wall_behind_loose_triangles(RandomNumbers& numbers);

// A box from -1 to 1, and triangles upright on each axis in the planes of its own grid of that many
// cells along each axis, with corners where three planes meet.
Mesh triangles_in_planes_of_cells(RandomNumbers& numbers, int cells);

// A ball of 980 triangles among twenty triangles a thousand times as large: a teapot in a stadium.
Mesh teapot_in_a_stadium(RandomNumbers& numbers);

} // namespace raysteps
