// A uniform grid, walked cell by cell as the ray meets them. Every triangle of every cell on the
// way is tested: one that lies in several of them, several times. Source: Amanatides and Woo, "A
// Fast Voxel Traversal Algorithm for Ray Tracing", 1987, but with each crossing computed from the
// index of its plane.
//
// Within a cell, the ray's t lies between the crossings of its planes on every axis: so it is at
// the start, and so it stays, since each step crosses the plane that comes first. A hit at t has
// its point within the padding of the cell that holds t, so that cell lists the triangle. Therefore
// a hit is final only when it comes before the crossing that leaves the cell: one that lies farther
// on is kept, and may be beaten in the cells between.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int number = walk.place.x;
    int face = walk.place.z; // structure/grid/grid_mailbox.glsl shows what it is good for
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
            //# exercise 4.4: the step to the next cell
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
            //# stub: ended = true;
            //# end
        }
    }
    walk.nearest = nearest;
    walk.place = ivec3(number, next, face);
    walk.ended = ended;
    return walk;
}
