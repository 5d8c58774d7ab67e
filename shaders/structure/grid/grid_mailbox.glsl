// A uniform grid, in which no triangle is tested again in the next cell. A mailbox (Amanatides and
// Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987) would note at each triangle the
// ray that tested it last; but here rays go in parallel and cannot write. Instead each reference
// knows in which neighbours its triangle is listed: the ray has just left one of those, and leaves
// a cell only when all of its triangles are tested.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

bool is_tested(int reference, int face) {
    return face != no_grid_face && is_across_grid_face(reference, face);
}

#include "structure/grid/grid_walk.glsl"
