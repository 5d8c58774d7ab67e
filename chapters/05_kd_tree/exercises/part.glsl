// The part of the ray in the box of the tree.

uvec4 checkpoint(Ray ray, int step) {
    KdPart part = part_in_tree(ray);
    bool is_miss = part.exit < part.entry;
    return uvec4(is_miss ? 0u : bits(part.entry), is_miss ? 0u : bits(part.exit), is_miss ? 1u : 0u,
                 0u);
}
