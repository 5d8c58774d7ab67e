// A kd-tree, walked without a stack: after each leaf, up to the first node whose box the ray has
// not left yet, and down again from there. Source: Foley and Sugerman, "KD-tree acceleration
// structures for a GPU raytracer", 2005.
#include "structure/kd_tree/kd_nodes.glsl"
#include "structure/kd_tree/kd_descent.glsl"

Walk start_walk(Ray ray) {
    return start_kd_walk(ray);
}

struct KdClimb {
    int place;
    real exit;
    int steps;
};

KdClimb climb(int place, Ray ray, real t) {
    KdClimb up;
    up.place = place;
    up.exit = box_exit(place, ray).t;
    up.steps = 0;
    //# exercise 5.4: up to a box that the ray is still in
    while (up.exit <= t && up.place != kd_root) {
        up.place = kd_parent(up.place);
        up.exit = box_exit(up.place, ray).t;
        up.steps = up.steps + 1;
        observe_visit(up.place);
    }
    //# stub: up.place = kd_root;
    //# stub: up.exit = box_exit(kd_root, ray).t;
    //# end
    return up;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    real end = part_in_tree(ray).exit;
    KdVisit visit;
    visit.walk = walk;
    visit.rounds = rounds;
    while (visit.rounds > 0 && !visit.walk.ended) {
        real t = reached(visit.walk);
        KdClimb up = climb(visit.walk.place.y, ray, t);
        KdDescent leaf = descend(up.place, ray, t, up.exit < end ? up.exit : end);
        visit = visit_leaf(visit.walk, leaf, prepared, end, near_enough,
                           visit.rounds - up.steps - leaf.steps);
    }
    return visit.walk;
}
