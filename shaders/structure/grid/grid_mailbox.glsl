// A uniform grid, in which no triangle is tested again in the next cell. A mailbox (Amanatides and
// Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987) would note at each triangle the
// ray that tested it last; but here rays go in parallel and cannot write. Instead each reference
// knows in which neighbours its triangle is listed: the ray has just left one of those, and leaves
// a cell only when all of its triangles are tested.
// Otherwise the walk is that of structure/grid/grid.glsl.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

// Whether the cell that the ray came from lists the triangle too: then it was tested there.
bool is_tested(int reference, int face) {
    return face != no_grid_face && is_across_grid_face(reference, face);
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int number = walk.place.x;
    int face = walk.place.z;
    ivec3 cell = grid_cell_of(number);
    real3 leaves = real3(leaving(ray, 0, cell.x), leaving(ray, 1, cell.y), leaving(ray, 2, cell.z));
    int next = walk.place.y;
    if (next < 0) {
        observe_visit(number);
        next = grid_start(number);
    }
    int end = grid_start(number + 1);
    bool ended = false;
    for (int round = 0; round < rounds && !ended; ++round) {
        // Passed over in a loop of its own: rays that run side by side wait for each other's tests,
        // and a test that is passed over among them would cost as much as one that is made.
        for (; round < rounds && next < end && is_tested(grid_reference(next), face); ++round) {
            ++next;
        }
        if (next < end) {
            int i = grid_triangle(grid_reference(next));
            ++next;
            observe_test(i);
            Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                         triangle_corner(i, 2), i);
            if (is_nearer(hit, nearest) && is_solid(hit)) {
                nearest = hit;
                ended = hit.t <= near_enough;
            }
        } else {
            int axis = first_axis(leaves);
            // A ray that goes along no axis, or is not a number, ends here as well.
            ended = nearest.t < leaves[axis] || !(leaves[axis] < real(farthest));
            bool up = goes_up(ray, axis);
            int i = up ? cell[axis] + 1 : cell[axis] - 1;
            ended = ended || i < 0 || i >= grid_cells[axis];
            if (!ended) {
                cell[axis] = i;
                leaves[axis] = leaving(ray, axis, i);
                face = up ? 2 * axis : 2 * axis + 1;
                number = grid_cell_number(cell);
                next = grid_start(number);
                end = grid_start(number + 1);
                observe_visit(number);
            }
        }
    }
    walk.nearest = nearest;
    walk.place = ivec3(number, next, face);
    walk.ended = ended;
    return walk;
}
