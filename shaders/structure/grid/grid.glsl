// A uniform grid, in which every triangle of every cell on the way is tested: one that lies in
// several of them, several times.
#include "layout/grid.glsl"
#include "geometry/grid_plane.glsl"
#include "geometry/grid_crossing.glsl"

bool is_tested(int reference, int face) {
    return false;
}

#include "geometry/grid_walk.glsl"
