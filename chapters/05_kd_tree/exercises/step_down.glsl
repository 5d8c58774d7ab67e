// One step down at a node that is split at x = 0.5, with the children 10 (below) and 11 (above),
// from t_min on; the ray leaves the node at t_max. The other steps take another axis in turn, with
// another split and other children. From step 4 on t is where the ray meets the plane, or beside
// it, and from step 7 on the exit is.

uvec4 checkpoint(Ray ray, int step) {
    KdNode node;
    node.axis = (step - 1) % 3;
    node.split = node.axis == 0 ? real(0.5f) : node.axis == 1 ? -real(0.75f) : real(1.25f);
    node.first_child = node.axis == 0 ? 10 : node.axis == 1 ? 4 : 20;
    node.first_reference = 0;
    node.end_reference = 0;
    node.leaf = 0;
    real split = plane_distance(node.split, ray, node.axis);
    real beside = step % 2 == 0 ? just_below(split) : just_above(split);
    real t = ray.t_min;
    real exit = ray.t_max;
    bool is_number = is_finite(split);
    if (is_number && step > 3 && step <= 6) {
        t = split;
    } else if (is_number && step > 6 && step <= 12) {
        t = beside;
        exit = real(farthest);
    } else if (is_number && step > 12 && step <= 15) {
        exit = split;
    } else if (is_number && step > 15) {
        exit = beside;
    }
    KdStep taken = step_down(node, ray, t, exit);
    also = uvec4(uint(node.axis), bits(t), bits(exit), 0u);
    return uvec4(uint(taken.child), uint(taken.other), bits(taken.exit), 0u);
}
