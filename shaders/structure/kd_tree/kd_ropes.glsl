// A kd-tree, walked without a stack: after each leaf, on to the neighbour behind the face through
// which the ray leaves. Source: Popov, Guenther, Seidel and Slusallek, "Stackless KD-tree traversal
// for high performance GPU ray tracing", 2007, after Havran, Bittner and Zara, "Ray tracing with
// rope trees", 1998.
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
        real t = reached(visit.walk);
        KdDescent leaf = descend(visit.walk.place.y, ray, t, end);
        KdExit exit = box_exit(leaf.place, ray);
        leaf.exit = exit.t < end ? exit.t : end;
        visit.rounds = visit.rounds - leaf.steps;
        // Where a ray runs through an edge or a corner of a leaf, the rope leads to a leaf that it
        // only touches. The right one is a rope or two farther.
        bool only_touched = leaf.exit <= t && leaf.exit < end;
        if (!only_touched || leaf.node.axis != kd_leaf) {
            visit = visit_leaf(visit.walk, leaf, prepared, end, near_enough, visit.rounds);
        }
        bool is_whole = leaf.node.axis == kd_leaf;
        if (is_whole && (only_touched || has_left_leaf(visit.walk))) {
            visit.walk.place.y = kd_rope(leaf.node.leaf, exit.face);
        }
    }
    return visit.walk;
}
