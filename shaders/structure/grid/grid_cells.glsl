// A uniform grid: grid_cells boxes of the size grid_cell_size from the point grid_lower on. Cell
// (x, y, z) has the number x + cells.x * (y + cells.y * z), and the references from
// grid_starts[number] up to grid_starts[number + 1]. A reference has the triangle in its low 26
// bits; bit 26 + f says that the neighbour across face f lists it too. Face 2 * axis is the lower
// one of the axis, 2 * axis + 1 the upper one.
uniform vec3 grid_lower;
uniform vec3 grid_cell_size;
uniform ivec3 grid_cells;
uniform isamplerBuffer grid_starts;
uniform isamplerBuffer grid_references;

const int no_grid_face = 6; // a walk starts within a cell, and entered it through no face

int grid_start(int cell) {
    return texelFetch(grid_starts, cell).x;
}

int grid_reference(int place) {
    return texelFetch(grid_references, place).x;
}

int grid_triangle(int reference) {
    return reference & 0x3ffffff;
}

bool is_across_grid_face(int reference, int face) {
    return ((reference >> (26 + face)) & 1) != 0;
}

int grid_cell_number(ivec3 cell) {
    return cell.x + grid_cells.x * (cell.y + grid_cells.y * cell.z);
}

ivec3 grid_cell_of(int number) {
    int row = number / grid_cells.x;
    return ivec3(number - row * grid_cells.x, row % grid_cells.y, row / grid_cells.y);
}

// Where a ray crosses the planes of a grid: always computed from the index of the plane, never by
// adding up, which would drift.

bool goes_up(Ray ray, int axis) {
    return ray.direction[axis] > real(0.0f);
}

bool goes_along(Ray ray, int axis) {
    return ray.direction[axis] != real(0.0f);
}

real plane_of_grid(int axis, int i) {
    return grid_plane(real(grid_lower[axis]), real(grid_cell_size[axis]), i);
}

// The t at which the ray, which goes along the axis, meets the plane. Rounding keeps the order of
// the planes.
real crossing(Ray ray, int axis, int plane) {
    precise real t = (plane_of_grid(axis, plane) - ray.origin[axis]) / ray.direction[axis];
    return t;
}

// The t at which the ray leaves cell i of the axis; `farthest` where it does not go along it.
real leaving(Ray ray, int axis, int i) {
    return goes_along(ray, axis) ? crossing(ray, axis, goes_up(ray, axis) ? i + 1 : i)
                                 : real(farthest);
}

// Whether the cells of the axis that come before this plane are behind the ray at t: their place
// decides where the ray does not go along the axis.
bool is_passed(Ray ray, int axis, int plane, real t) {
    return goes_along(ray, axis) ? crossing(ray, axis, plane) < t
                                 : plane_of_grid(axis, plane) < ray.origin[axis];
}

// The cell along one axis where the ray is at t: the first one, as the ray goes, that it has not
// left before. Found by halving, with the very numbers by which the walk goes on, so that no
// rounding can put it beside the ray; and whatever the numbers are, it is a cell of the grid.
int cell_at(Ray ray, int axis, real t) {
    int last = grid_cells[axis] - 1;
    bool downwards = ray.direction[axis] < real(0.0f);
    int low = 0;
    //# exercise 4.2: the first cell
    int high = last;
    while (low < high) {
        int middle = (low + high) / 2;
        if (is_passed(ray, axis, downwards ? last - middle : middle + 1, t)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    //# stub: low = 0;
    //# end
    return downwards ? last - low : low;
}

// The part of the ray within the grid; a miss is a part whose end is before its start.
struct GridPart {
    real start;
    real end;
};

GridPart part_in_grid(Ray ray) {
    GridPart part;
    part.start = ray.t_min;
    part.end = min(ray.t_max, real(farthest));
    for (int axis = 0; axis < 3; ++axis) {
        int last = grid_cells[axis];
        bool up = goes_up(ray, axis);
        if (goes_along(ray, axis)) {
            //# exercise 4.1: the part of a ray in the grid
            real enters = crossing(ray, axis, up ? 0 : last);
            real leaves = crossing(ray, axis, up ? last : 0);
            part.start = enters > part.start ? enters : part.start;
            part.end = leaves < part.end ? leaves : part.end;
            //# stub: part.end = -real(farthest);
            //# end
        } else if (ray.origin[axis] < plane_of_grid(axis, 0) ||
                   ray.origin[axis] > plane_of_grid(axis, last)) {
            part.start = real(farthest);
            part.end = -real(farthest);
        }
    }
    return part;
}

// Where a walk through the grid begins. place.x is the number of the cell, place.y the next
// reference (-1: the cell is still to be entered), place.z the face through which the ray came.
Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(0, -1, no_grid_face);
    GridPart part = part_in_grid(ray);
    walk.ended = is_empty(ray) || part.end < part.start;
    if (!walk.ended) {
        walk.place.x = grid_cell_number(ivec3(
            cell_at(ray, 0, part.start), cell_at(ray, 1, part.start), cell_at(ray, 2, part.start)));
    }
    return walk;
}

// The axis of the least of the three, the first of them where some are equal.
int first_axis(real3 t) {
    //# exercise 4.3: the plane that comes first
    int x_or_z = t.x <= t.z ? 0 : 2;
    int y_or_z = t.y <= t.z ? 1 : 2;
    return t.x <= t.y ? x_or_z : y_or_z;
    //# stub: return 0;
    //# end
}
