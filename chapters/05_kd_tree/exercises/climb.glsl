// Up from the leaf that the ray meets first, when the ray has come to the leaf's exit; from step 2
// on, when it is elsewhere: just before that exit, at the exit of the leaf's parent and of those
// above, or just before it.

uvec4 checkpoint(Ray ray, int step) {
    KdPart part = part_in_tree(ray);
    if (!(part.entry <= part.exit)) {
        return uvec4(0u, 0u, 0u, 1u);
    }
    KdDescent leaf = descend(kd_root, ray, part.entry, part.exit);
    int ancestor = leaf.place;
    for (int up = 0; up < (step - 1) / 2 && ancestor != kd_root; ++up) {
        ancestor = kd_parent(ancestor);
    }
    real t = step < 3 ? leaf.exit : box_exit(ancestor, ray).t;
    t = step % 2 == 0 ? just_below(t) : t;
    KdClimb up = climb(leaf.place, ray, t);
    also = uvec4(bits(t), 0u, 0u, 0u);
    return uvec4(uint(up.place), bits(up.exit), uint(up.steps), 0u);
}
