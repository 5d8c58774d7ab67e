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
