// Where the walk is after so many launches.

uvec4 checkpoint(Ray ray, int step) {
    Walk walk = walk_after(ray, step);
    also = uvec4(uint(walk.place.y), bits(walk.nearest.t), 0u, 0u);
    return uvec4(uint(walk.place.x), uint(walk.place.z), walk.ended ? 1u : 0u,
                 uint(walk.nearest.triangle));
}
