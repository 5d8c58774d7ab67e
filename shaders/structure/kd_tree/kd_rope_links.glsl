// The ropes of a kd-tree's leaves, six a leaf: behind its lower face along x, its upper one along
// x, and so on, the smallest node that holds the whole face; -1 where the tree ends.
uniform isamplerBuffer kd_ropes;

int kd_rope(int leaf, int face) {
    return texelFetch(kd_ropes, 6 * leaf + face).x;
}
