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
