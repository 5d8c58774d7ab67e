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
