// Where the walk is after so many rounds: a round tests one triangle, or goes on to the next cell.

uvec4 checkpoint(Ray ray, int step) {
    Walk walk = walk_after(ray, step);
    return uvec4(uint(walk.place.x), uint(walk.place.z), walk.ended ? 1u : 0u,
                 uint(walk.nearest.triangle));
}
