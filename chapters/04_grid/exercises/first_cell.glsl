// The cell in which the walk starts; -1, -1, -1 where the ray misses the grid. From step 2 on, the
// cells where the ray is at another t: at which it crosses a plane, or just after it. The steps go
// through five planes of each axis.

uvec4 checkpoint(Ray ray, int step) {
    real t;
    if (step == 1) {
        GridPart part = part_in_grid(ray);
        if (part.end < part.start) {
            return uvec4(uint(-1), uint(-1), uint(-1), bits(ray.t_min));
        }
        t = part.start;
    } else {
        int axis = (step - 2) % 3;
        int plane = ((step - 2) / 3 % 5) * grid_cells[axis] / 4;
        t = goes_along(ray, axis) ? crossing(ray, axis, plane) : real(plane);
        t = step > 16 ? just_above(t) : t;
    }
    return uvec4(uint(cell_at(ray, 0, t)), uint(cell_at(ray, 1, t)), uint(cell_at(ray, 2, t)),
                 bits(t));
}
