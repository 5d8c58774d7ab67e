// Where the walk is after so many rounds, each of them in a launch of its own: the next place in
// the tree, the next triangle of a leaf, and the nearest hit.

uvec4 checkpoint(Ray ray, int step) {
    Walk walk = walk_after(ray, step);
    return uvec4(uint(walk.place.x), uint(walk.place.y), uint(walk.nearest.triangle),
                 walk.ended ? 1u : 0u);
}
