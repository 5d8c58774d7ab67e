// A kd-tree, walked with a stack that remembers the last eight nodes put off, and forgets those
// before. When it is empty, down again, not from the root, but from the last node that holds the
// whole rest of the ray (push-down). Source: Horn, Sugerman, Houston and Hanrahan, "Interactive k-D
// tree GPU raytracing", 2007.
#include "structure/kd_tree/kd_nodes.glsl"
#include "structure/kd_tree/kd_descent.glsl"

const int short_stack_size = 8;

Walk start_walk(Ray ray) {
    return start_kd_walk(ray);
}

// A launch begins with an empty stack. place.y is the node that holds the rest of the ray.
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    real end = part_in_tree(ray).exit;
    // Plain arrays: in a struct that functions take and give, drivers copy all of it.
    int places[8];  // nodes that the ray comes to at its present exit
    real exits[8];  // where it leaves them
    int top = 0;    // how many were ever put in; the last one is at (top - 1) % short_stack_size
    int filled = 0; // how many of the last ones are still there
    int holds_rest = walk.place.y;
    KdVisit visit;
    visit.walk = walk;
    visit.rounds = rounds;
    while (visit.rounds > 0 && !visit.walk.ended) {
        real t = reached(visit.walk);
        KdDescent leaf;
        leaf.place = holds_rest;
        leaf.exit = end;
        bool from_stack = filled > 0;
        if (from_stack) {
            top = top - 1;
            filled = filled - 1;
            leaf.place = places[top % short_stack_size];
            leaf.exit = exits[top % short_stack_size];
        }
        leaf.node = kd_node(leaf.place);
        leaf.steps = 1;
        observe_visit(leaf.place);
        bool whole_rest = !from_stack;
        while (leaf.node.axis != kd_leaf) {
            KdStep taken = step_down(leaf.node, ray, t, leaf.exit);
            if (taken.other >= 0) {
                places[top % short_stack_size] = taken.other;
                exits[top % short_stack_size] = leaf.exit;
                top = top + 1;
                filled = min(filled + 1, short_stack_size);
                whole_rest = false;
            }
            leaf.place = taken.child;
            leaf.node = kd_node(taken.child);
            leaf.exit = taken.exit;
            leaf.steps = leaf.steps + 1;
            observe_visit(taken.child);
            holds_rest = whole_rest ? taken.child : holds_rest;
        }
        visit = visit_leaf(visit.walk, leaf, prepared, end, near_enough, visit.rounds - leaf.steps);
        visit.walk.place.y = holds_rest;
    }
    return visit.walk;
}
