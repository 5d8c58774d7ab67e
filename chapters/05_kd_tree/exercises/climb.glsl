// Up from the leaf that the ray meets first, when the ray has come to the leaf's exit.

uvec4 checkpoint(Ray ray, int step) {
    KdPart part = part_in_tree(ray);
    if (!(part.entry <= part.exit)) {
        return uvec4(0u, 0u, 0u, 1u);
    }
    KdDescent leaf = descend(kd_root, ray, part.entry, part.exit);
    KdClimb up = climb(leaf.place, ray, leaf.exit);
    return uvec4(uint(up.place), bits(up.exit), uint(up.steps), 0u);
}
