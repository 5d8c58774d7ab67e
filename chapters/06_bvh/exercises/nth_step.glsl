// Where the walk is after so many launches: the next node, the next triangle of a leaf, and the
// nearest hit; beside them its t, u and v, and whether the node is done.

uvec4 checkpoint(Ray ray, int step) {
    Walk walk = walk_after(ray, step);
    also = uvec4(bits_of_hit(walk.nearest).xyz, uint(walk.place.z));
    return uvec4(uint(walk.place.x), uint(walk.place.y), uint(walk.nearest.triangle),
                 walk.ended ? 1u : 0u);
}
