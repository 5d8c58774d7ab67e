// A kd-tree, walked without a stack: after each leaf, down again from the root. Source: Foley and
// Sugerman, "KD-tree acceleration structures for a GPU raytracer", 2005.
#include "structure/kd_tree/kd_nodes.glsl"
#include "structure/kd_tree/kd_descent.glsl"

Walk start_walk(Ray ray) {
    return start_kd_walk(ray);
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    real end = part_in_tree(ray).exit;
    KdVisit visit;
    visit.walk = walk;
    visit.rounds = rounds;
    while (visit.rounds > 0 && !visit.walk.ended) {
        KdDescent leaf = descend(kd_root, ray, reached(visit.walk), end);
        visit = visit_leaf(visit.walk, leaf, prepared, end, near_enough, visit.rounds - leaf.steps);
    }
    return visit.walk;
}
