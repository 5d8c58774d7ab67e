// The part of the ray within the grid.

uvec4 checkpoint(Ray ray, int step) {
    GridPart part = part_in_grid(ray);
    bool is_miss = part.end < part.start;
    return uvec4(is_miss ? 0u : bits(part.start), is_miss ? 0u : bits(part.end), is_miss ? 1u : 0u,
                 0u);
}
