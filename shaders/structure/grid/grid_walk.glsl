// The walk through a uniform grid, cell by cell as the ray meets them. Source: Amanatides and Woo,
// "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987, but with each crossing computed from
// the index of its plane. The part before says, in is_tested, which references may be skipped.
//
// place.x is the number of the cell, place.y the next reference (-1: the cell is still to be
// entered), place.z the face through which the ray came.
//
// Within a cell, the ray's t lies between the crossings of its planes on every axis: so it is at
// the start, and so it stays, since each step crosses the plane that comes first. A hit at t has
// its point within the padding of the cell that holds t, so that cell lists the triangle. Therefore
// a hit is final only when it comes before the crossing that leaves the cell: one that lies farther
// on is kept, and may be beaten in the cells between.

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
            if (is_nearer(hit, nearest)) {
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
