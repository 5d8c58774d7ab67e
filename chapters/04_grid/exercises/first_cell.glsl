// The cell in which the walk starts; -1, -1, -1 where the ray misses the grid.

uvec4 checkpoint(Ray ray, int step) {
    GridPart part = part_in_grid(ray);
    if (part.end < part.start) {
        return uvec4(uint(-1), uint(-1), uint(-1), 0u);
    }
    return uvec4(uint(cell_at(ray, 0, part.start)), uint(cell_at(ray, 1, part.start)),
                 uint(cell_at(ray, 2, part.start)), 0u);
}
