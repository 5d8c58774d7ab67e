// How a ray goes down a kd-tree from t on.
//
// Every distance of a plane is this one expression of the plane as it is stored. So two walks, or
// two descents of one walk, never disagree about where they are, and no rounding has to be made up
// for by an epsilon.

real plane_distance(real plane, Ray ray, int axis) {
    precise real t = (plane - ray.origin[axis]) / ray.direction[axis];
    return t;
}

// The part of the ray in the root's box, [entry, exit]; empty where exit < entry. Written so that
// a number which is none never counts.
struct KdPart {
    real entry;
    real exit;
};

KdPart part_in_tree(Ray ray) {
    KdPart part;
    part.entry = ray.t_min;
    part.exit = min(ray.t_max, real(farthest)); // an exit may be compared, so it is a number
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis) {
        real origin = ray.origin[axis];
        real lower = real(kd_lower[axis]);
        real upper = real(kd_upper[axis]);
        if (ray.direction[axis] == real(0.0f)) {
            outside = outside || origin < lower || origin > upper;
        } else {
            //# exercise 5.1: the part of a ray in the tree
            bool ascends = ray.direction[axis] > real(0.0f);
            real near = plane_distance(ascends ? lower : upper, ray, axis);
            real far = plane_distance(ascends ? upper : lower, ray, axis);
            part.entry = near > part.entry ? near : part.entry;
            part.exit = far < part.exit ? far : part.exit;
            //# stub: outside = true;
            //# end
        }
    }
    if (outside) {
        part.entry = real(farthest);
        part.exit = real(-farthest);
    }
    return part;
}

// One step down: the child that holds the ray at t and just after, and where the ray leaves it for
// the other one.
struct KdStep {
    int child;
    int other; // -1 where the ray does not come to it before the exit
    real exit;
};

// The order of the children is that of the direction: so the ray is in the second one from the
// plane's t on, wherever its origin lies. At the plane itself it is in the second one already: that
// is what makes every walk move on. A ray along the plane is never divided by zero: it is where its
// origin is.
KdStep step_down(KdNode node, Ray ray, real t, real exit) {
    KdStep taken;
    taken.other = -1;
    taken.exit = exit;
    real direction = ray.direction[node.axis];
    int lower = node.first_child;
    int upper = node.first_child + 1;
    if (direction == real(0.0f)) {
        taken.child = ray.origin[node.axis] <= node.split ? lower : upper;
        return taken;
    }
    //# exercise 5.2: one step down
    int first = direction > real(0.0f) ? lower : upper;
    int second = direction > real(0.0f) ? upper : lower;
    real t_split = plane_distance(node.split, ray, node.axis);
    taken.child = t_split <= t ? second : first;
    if (t_split > t && t_split < exit) {
        taken.other = second;
        taken.exit = t_split;
    }
    //# stub: taken.child = lower;
    //# end
    return taken;
}

// The leaf that holds the ray at t and just after.
struct KdDescent {
    int place;
    KdNode node;
    real exit;
    int steps;
};

KdDescent descend(int place, Ray ray, real t, real exit) {
    KdDescent descent;
    descent.place = place;
    descent.node = kd_node(place);
    descent.exit = exit;
    descent.steps = 1;
    observe_visit(place);
    while (descent.node.axis != kd_leaf) {
        KdStep taken = step_down(descent.node, ray, t, descent.exit);
        descent.place = taken.child;
        descent.node = kd_node(taken.child);
        descent.exit = taken.exit;
        descent.steps = descent.steps + 1;
        observe_visit(taken.child);
    }
    return descent;
}

// Where a ray leaves a node's box, and through which face: 2 * axis the lower one, 2 * axis + 1 the
// upper one. The planes are those of the splits, so the distances are those of the descent, bit for
// bit. A ray that ascends or descends along no axis never leaves.

struct KdExit {
    real t;
    int face; // -1 where it never leaves
};

KdExit box_exit(int place, Ray ray) {
    real3 lower = kd_box_lower(place);
    real3 upper = kd_box_upper(place);
    KdExit exit;
    exit.t = real(farthest);
    exit.face = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] != real(0.0f)) {
            //# exercise 5.3: the face through which a ray leaves
            bool ascends = ray.direction[axis] > real(0.0f);
            real t = plane_distance(ascends ? upper[axis] : lower[axis], ray, axis);
            if (t < exit.t) {
                exit.t = t;
                exit.face = ascends ? 2 * axis + 1 : 2 * axis;
            }
            //# stub: exit.face = -1;
            //# end
        }
    }
    return exit;
}

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
        if (is_nearer(hit, nearest) && is_solid(hit)) {
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
