// Where the plane between cells i - 1 and i of a grid lies along one axis. The builder and the walk
// compute it with this one text, from the index and never by adding up, so that all mean the same
// plane. It never goes back as i grows: of two products, and of two sums, the greater rounds to no
// less than the smaller.
real grid_plane(real lower, real cell_size, int i) {
    precise real plane = lower + cell_size * real(i);
    return plane;
}
