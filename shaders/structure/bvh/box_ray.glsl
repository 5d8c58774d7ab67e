// A ray, prepared for boxes: what is the same for all of them is computed once.
//
// A plane's t is (plane - origin) * inverse, which is rounded three times (difference, inverse,
// product): the point there moves by at most 3 e M along its axis (structure/padding.h has e and
// M). A hit at t lies within 23 e M of its triangle, whose boxes reach 32 e M beyond it. So the t
// of the box's first plane is at most that of the hit, the t of its last plane at least, in floats
// too: no box around the triangle is missed. The other form, plane * inverse - origin * inverse, is
// rounded by the size of the coordinates, not by M, and far from zero no padding would do.
//
// Along an axis where the ray does not go, it is its place that decides: inside, the first plane
// lies before everything and the last one behind. Nothing is divided by zero for it: such a ray
// creeps as slowly as numbers can, and the origin is moved away from the plane by a hair, so even
// in the very plane of a side it has a distance, and (plane - origin) * inverse is large. At a
// box that is padded the distance is 9 e M or more, so |t| is over 2^107 M, and a ray with a
// component over 2^-60 has no hit beyond 2^60 M. A component under 2^-126 counts as none, since a
// GPU may flush it: beside one over 2^-60 it moves no hit by e M. Of a ray with only smaller
// components, the origin is moved as far as can be, so that such an axis leaves out no box at all.
const float least_component = 1.1754943508222875e-38f; // 2^-126
const float least_direction = 8.673617379884035e-19f;  // 2^-60
const float hair = 8.673617379884035e-19f;             // 2^-60, and 2^-22 of the coordinate
const float hair_part = 2.384185791015625e-7f;

struct BoxRay {
    real3 first_origin; // to measure to the planes that the ray comes to first
    real3 last_origin;
    real3 inverse; // of the direction; never zero
    real t_min;
};

BoxRay box_ray(Ray ray) {
    BoxRay prepared;
    prepared.first_origin = ray.origin;
    prepared.last_origin = ray.origin;
    prepared.inverse = real3(farthest);
    prepared.t_min = ray.t_min;
    real longest = max(abs(ray.direction.x), max(abs(ray.direction.y), abs(ray.direction.z)));
    for (int axis = 0; axis < 3; ++axis) {
        if (abs(ray.direction[axis]) >= real(least_component)) {
            precise real inverse = real(1.0f) / ray.direction[axis];
            prepared.inverse[axis] = inverse;
        } else {
            precise real little = real(hair) + abs(ray.origin[axis]) * real(hair_part);
            real aside = longest >= real(least_direction) ? little : real(farthest);
            precise real beyond = ray.origin[axis] + aside;
            precise real before = ray.origin[axis] - aside;
            prepared.first_origin[axis] = beyond;
            prepared.last_origin[axis] = before;
        }
    }
    return prepared;
}

bool descends(BoxRay ray, int axis) {
    return ray.inverse[axis] < real(0.0f);
}

// Where the ray is within the three pairs of planes: from entry to exit, where that is not empty.
struct BoxSpan {
    real entry;
    real exit;
};

// The part of the ray up to t_max. The planes are given as the ray comes to them. NaNs fail
// every comparison, so they are ignored.
BoxSpan span_in_box(BoxRay ray, real3 first_planes, real3 last_planes, real t_max) {
    precise real3 enters = (first_planes - ray.first_origin) * ray.inverse;
    precise real3 leaves = (last_planes - ray.last_origin) * ray.inverse;
    BoxSpan span;
    //# exercise 6.1: the part of a ray in a box
    span.entry = enters.x > ray.t_min ? enters.x : ray.t_min;
    span.entry = enters.y > span.entry ? enters.y : span.entry;
    span.entry = enters.z > span.entry ? enters.z : span.entry;
    span.exit = leaves.x < t_max ? leaves.x : t_max;
    span.exit = leaves.y < span.exit ? leaves.y : span.exit;
    span.exit = leaves.z < span.exit ? leaves.z : span.exit;
    //# stub: span.entry = ray.t_min;
    //# stub: span.exit = t_max;
    //# end
    return span;
}
