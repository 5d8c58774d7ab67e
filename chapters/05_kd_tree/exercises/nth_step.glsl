// Where the walk is after so many launches: its t, and what it has found.

uvec4 checkpoint(Ray ray, int step) {
    Walk walk = walk_after(ray, step);
    also = uvec4(uint(walk.place.y), uint(walk.place.z), bits(walk.nearest.t), 0u);
    return uvec4(walk.ended ? 0u : uint(walk.place.x), walk.ended ? 1u : 0u,
                 uint(walk.nearest.triangle), 0u);
}
