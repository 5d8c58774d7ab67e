// A whole walk: cell by cell through the grid. In a check it takes the place of
// structure/grid/grid.glsl. start_walk is given (structure/grid/grid_cells.glsl).
//
// The contract, beside that of chapter 02 (a launch takes the walk up where the one before has
// left it, makes at most `rounds` rounds, and its end changes nothing):
//
// - place.x is the number of the cell. place.y is its next reference, or -1 where the walk has
//   just begun and the cell is still to be entered. place.z is not used here.
// - To enter a cell is to call observe_visit(number) and to make place.y its first reference. The
//   first cell is entered by the first launch, and that is no round.
// - A round tests the triangle of one reference, after observe_test; or, where none is left, it
//   goes on: to the end of the walk, or to the next cell, which it enters.
// - Which is the next cell? The one behind the plane that the ray meets first: leaving(ray, axis,
//   i) is the t at which it leaves cell i of an axis, first_axis of the three says which is least,
//   and goes_up(ray, axis) on which side the next cell lies.
// - The walk goes on to its end where the nearest hit lies before that plane, strictly; where the
//   ray never comes to it, and its t is not less than `farthest`; and where the next cell is
//   outside of the grid. It ends at once with a hit whose t is at most near_enough.
//
// The references of a cell are the places from grid_start(number) to the one before
// grid_start(number + 1). Beside what chapter 02 lists (prepare_ray(), which gives a PreparedRay,
// intersect_triangle(), triangle_corner(), is_nearer(), miss(), observe_test()), these are at hand:
//
//     int grid_start(int number), int grid_reference(int place), int grid_triangle(int reference)
//     ivec3 grid_cell_of(int number), int grid_cell_number(ivec3 cell)
//     real leaving(Ray ray, int axis, int i), int first_axis(real3 leaves)
//     bool goes_up(Ray ray, int axis), and ivec3 grid_cells: how many cells along each axis
//
// Of a walk that has ended, a check shows the place as 0.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

//# exercise 4.6: a whole walk, through the grid
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    if (walk.place.y < 0) {
        observe_visit(walk.place.x);
        walk.place.y = grid_start(walk.place.x);
    }
    for (int left = rounds; left > 0 && !walk.ended; --left) {
        if (walk.place.y < grid_start(walk.place.x + 1)) {
            int i = grid_triangle(grid_reference(walk.place.y));
            walk.place.y = walk.place.y + 1;
            observe_test(i);
            Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                         triangle_corner(i, 2), i);
            if (is_nearer(hit, walk.nearest)) {
                walk.nearest = hit;
                walk.ended = hit.t <= near_enough;
            }
            continue;
        }
        ivec3 cell = grid_cell_of(walk.place.x);
        real3 leaves =
            real3(leaving(ray, 0, cell.x), leaving(ray, 1, cell.y), leaving(ray, 2, cell.z));
        int axis = first_axis(leaves);
        cell[axis] = cell[axis] + (goes_up(ray, axis) ? 1 : -1);
        bool outside = cell[axis] < 0 || cell[axis] >= grid_cells[axis];
        walk.ended = walk.nearest.t < leaves[axis] || !(leaves[axis] < real(farthest)) || outside;
        if (!walk.ended) {
            walk.place.x = grid_cell_number(cell);
            walk.place.y = grid_start(walk.place.x);
            observe_visit(walk.place.x);
        }
    }
    return walk;
}
//# stub: Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
//# stub:     walk.ended = true;
//# stub:     return walk;
//# stub: }
//# end
