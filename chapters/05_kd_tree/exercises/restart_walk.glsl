// A whole walk: a kd-tree, from the root again after each leaf. In a check it takes the place of
// structure/kd_tree/kd_restart.glsl.
//
// The contract, beside that of chapter 02 (a launch takes the walk up where the one before has
// left it, makes at most `rounds` rounds, and its end changes nothing but what is said below):
//
// - place.x has the bits of t up to where the ray is done (reached(walk) reads it; floatBitsToInt
//   (float(t)) writes it). place.z is the next reference of the leaf there, or all_references
//   where the leaf is still to be begun. place.y is not used here.
// - Down: descend(kd_root, ray, t, end) finds the leaf that holds the ray at t and just after,
//   where end is part_in_tree(ray).exit. It calls observe_visit, and takes as many rounds as
//   `steps` says. A launch that goes on begins with a descent, and a descent is never cut.
// - In the leaf, a round tests the triangle of one reference, after observe_test: from place.z on,
//   as long as rounds are left, but at least one after each descent. Otherwise a launch of few
//   rounds would get nowhere.
// - When the last one is tested, and that may be at once, the leaf is done: place.x has its exit,
//   and place.z is all_references. The walk ends there if the nearest hit lies before the exit,
//   strictly, or if the exit is not before `end`. Else it goes down again, as long as rounds are
//   left.
// - The walk ends at once with a hit whose t is at most near_enough.
//
// The references of a leaf are the places from node.first_reference to the one before
// node.end_reference, and texelFetch(kd_references, place).x is a reference's triangle. Beside what
// chapter 02 lists (prepare_ray(), which gives a PreparedRay, intersect_triangle(),
// triangle_corner(), is_nearer(), miss(), is_empty(), observe_test()), these are at hand:
//
//     KdPart part_in_tree(Ray ray)               entry and exit; the ray misses the tree where
//                                                entry <= exit does not hold
//     KdDescent descend(int place, Ray ray, real t, real exit)
//                                                place, node, exit and steps of the leaf
//     Walk start_kd_walk(Ray ray)                is start_walk, which you may call or write
//
// visit_leaf, which the project's walks share, is a part of this: write your own. Of a walk that
// has ended, a check shows the place as 0.
#include "structure/kd_tree/kd_nodes.glsl"
#include "structure/kd_tree/kd_descent.glsl"

//# exercise 5.6: a whole walk, down from the root again and again
Walk start_walk(Ray ray) {
    KdPart part = part_in_tree(ray);
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(floatBitsToInt(float(part.entry)), kd_root, all_references);
    walk.ended = is_empty(ray) || !(part.entry <= part.exit);
    return walk;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    real end = part_in_tree(ray).exit;
    int left = rounds;
    while (left > 0 && !walk.ended) {
        KdDescent leaf = descend(kd_root, ray, reached(walk), end);
        left = left - leaf.steps;
        int next = walk.place.z == all_references ? leaf.node.first_reference : walk.place.z;
        int stop = min(next + max(left, 1), leaf.node.end_reference);
        for (; next < stop && !walk.ended; ++next) {
            int i = texelFetch(kd_references, next).x;
            observe_test(i);
            Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                         triangle_corner(i, 2), i);
            if (is_nearer(hit, walk.nearest)) {
                walk.nearest = hit;
                walk.ended = hit.t <= near_enough;
            }
            left = left - 1;
        }
        walk.place.z = next;
        if (next >= leaf.node.end_reference && !walk.ended) {
            walk.place.x = floatBitsToInt(float(leaf.exit));
            walk.place.z = all_references;
            walk.ended = walk.nearest.t < leaf.exit || !(leaf.exit < end);
        }
    }
    return walk;
}
//# stub: Walk start_walk(Ray ray) {
//# stub:     return start_kd_walk(ray);
//# stub: }
//# stub: Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
//# stub:     walk.ended = true;
//# stub:     return walk;
//# stub: }
//# end
