// An exhibit: the walk of structure/grid/grid.glsl with crossings that are added up, step by step,
// as the published algorithm has it. Each sum is rounded, so the crossings drift, and with enough
// cells the walk leaves the cells that the ray goes through. (A new launch starts the sums anew, so
// here the drift is of one launch at most.) Not among the structures of --structure, which all give
// the same hits. Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
// 1987.
#include "structure/grid/grid_plane.glsl"
#include "structure/grid/grid_cells.glsl"

// What one cell adds to the crossings of its axis.
real crossing_step(Ray ray, int axis) {
    precise real step = real(grid_cell_size[axis]) / abs(ray.direction[axis]);
    return goes_along(ray, axis) ? step : real(0.0f);
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int number = walk.place.x;
    ivec3 cell = grid_cell_of(number);
    real3 leaves = real3(leaving(ray, 0, cell.x), leaving(ray, 1, cell.y), leaving(ray, 2, cell.z));
    real3 each = real3(crossing_step(ray, 0), crossing_step(ray, 1), crossing_step(ray, 2));
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
            int axis = leaves.x <= leaves.y ? (leaves.x <= leaves.z ? 0 : 2)
                                            : (leaves.y <= leaves.z ? 1 : 2);
            ended = nearest.t < leaves[axis] || !(leaves[axis] < real(farthest));
            int i = goes_up(ray, axis) ? cell[axis] + 1 : cell[axis] - 1;
            ended = ended || i < 0 || i >= grid_cells[axis];
            if (!ended) {
                cell[axis] = i;
                precise real sum = leaves[axis] + each[axis];
                leaves[axis] = sum;
                number = grid_cell_number(cell);
                next = grid_start(number);
                end = grid_start(number + 1);
                observe_visit(number);
            }
        }
    }
    walk.nearest = nearest;
    walk.place = ivec3(number, next, no_grid_face);
    walk.ended = ended;
    return walk;
}
