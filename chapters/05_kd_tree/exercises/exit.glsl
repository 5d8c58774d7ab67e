// Where the ray leaves the box of the tree's root, and through which face.

uvec4 checkpoint(Ray ray, int step) {
    KdExit exit = box_exit(kd_root, ray);
    return uvec4(bits(exit.t), uint(exit.face), 0u, 0u);
}
