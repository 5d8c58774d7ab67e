// A uniform grid, in which every triangle of every cell on the way is tested: one that lies in
// several of them, several times.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

bool is_tested(int reference, int face) {
    return false;
}

#include "structure/grid/grid_walk.glsl"
