// One step down at a node that is split at x = 0.5, with the children 10 (below) and 11 (above),
// from t_min on; the ray leaves the node at t_max.

uvec4 checkpoint(Ray ray, int step) {
    KdNode node;
    node.axis = 0;
    node.split = real(0.5f);
    node.first_child = 10;
    node.first_reference = 0;
    node.end_reference = 0;
    node.leaf = 0;
    KdStep taken = step_down(node, ray, ray.t_min, ray.t_max);
    return uvec4(uint(taken.child), uint(taken.other), bits(taken.exit), 0u);
}
