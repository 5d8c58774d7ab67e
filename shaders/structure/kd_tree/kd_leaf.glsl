// The triangles of a leaf, and how a walk leaves it. The place of a walk is: x, the bits of t where
// it is on the ray; y, a node to go on from; z, the next reference of the leaf there, or
// all_references.

const int all_references = -1;

Walk start_kd_walk(Ray ray) {
    KdPart part = part_in_tree(ray);
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(floatBitsToInt(float(part.entry)), kd_root, all_references);
    walk.ended = is_empty(ray) || !(part.entry <= part.exit);
    return walk;
}

real reached(Walk walk) {
    return real(intBitsToFloat(walk.place.x));
}

bool has_left_leaf(Walk walk) {
    return !walk.ended && walk.place.z == all_references;
}

struct KdVisit {
    Walk walk;
    int rounds; // that are left
};

// Tests the leaf's triangles, as many as there are rounds, but at least one. When the last one is
// done, the walk ends where nothing nearer can come: a hit before the exit, or the end of the ray.
// A hit at the exit itself lies on both sides, so the next leaf is asked too: of equal hits the
// smallest triangle wins. One beyond the exit is kept, and may be beaten.
KdVisit visit_leaf(Walk walk, KdDescent leaf, PreparedRay ray, real end, real near_enough,
                   int rounds) {
    KdVisit visit;
    if (leaf.node.axis != kd_leaf) { // the platform cut the descent: it is made again
        visit.walk = walk;
        visit.rounds = 0;
        return visit;
    }
    int first = walk.place.z == all_references ? leaf.node.first_reference : walk.place.z;
    int last = leaf.node.end_reference;
    int allowed = max(rounds, 1);
    int stop = allowed < last - first ? first + allowed : last;
    Hit nearest = walk.nearest;
    bool found = false;
    int i = first;
    for (; i < stop && !found; ++i) {
        int triangle = texelFetch(kd_references, i).x;
        observe_test(triangle);
        Hit hit =
            intersect_triangle(ray, triangle_corner(triangle, 0), triangle_corner(triangle, 1),
                               triangle_corner(triangle, 2), triangle);
        if (is_nearer(hit, nearest)) {
            nearest = hit;
            found = hit.t <= near_enough;
        }
    }
    visit.rounds = rounds - (i - first);
    visit.walk.nearest = nearest;
    visit.walk.place = ivec3(walk.place.x, leaf.place, i);
    visit.walk.ended = found;
    if (i == last && !found) {
        visit.walk.place = ivec3(floatBitsToInt(float(leaf.exit)), leaf.place, all_references);
        visit.walk.ended = nearest.t < leaf.exit || !(leaf.exit < end);
    }
    return visit;
}
