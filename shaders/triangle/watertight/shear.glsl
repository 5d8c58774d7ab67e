// A ray becomes the z axis by a shear, so that the question whether it meets a triangle is one of
// the plane: does the triangle surround the origin? Each corner is sheared by itself, so two
// triangles with a common edge see the same two points. Source: Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", 2013.

struct PreparedRay {
    real3 origin;
    real3 shear;
    real t_min;
    real t_max;
    int axis; // where the direction is longest: 0, 1, 2 for x, y, z
};

// Turns the axes so that the given one comes last.
real3 axis_last(real3 p, int axis) {
    real3 last_is_x = real3(p.y, p.z, p.x);
    real3 last_is_y = real3(p.z, p.x, p.y);
    return axis == 0 ? last_is_x : (axis == 1 ? last_is_y : p);
}

PreparedRay prepare_ray(Ray ray) {
    real x = abs(ray.direction.x);
    real y = abs(ray.direction.y);
    real z = abs(ray.direction.z);
    PreparedRay prepared;
    prepared.axis = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    real3 direction = axis_last(ray.direction, prepared.axis);
    precise real shear_x = direction.x / direction.z;
    precise real shear_y = direction.y / direction.z;
    precise real shear_z = real(1.0f) / direction.z;
    prepared.origin = ray.origin;
    prepared.shear = real3(shear_x, shear_y, shear_z);
    prepared.t_min = ray.t_min;
    prepared.t_max = min(ray.t_max, real(farthest)); // beyond, t is infinite and tells nothing
    return prepared;
}

real3 sheared(PreparedRay ray, real3 corner) {
    real3 p = axis_last(corner - ray.origin, ray.axis);
    //# exercise 2.5: a corner as the ray sees it
    precise real x = p.x - ray.shear.x * p.z;
    precise real y = p.y - ray.shear.y * p.z;
    precise real z = ray.shear.z * p.z;
    //# stub: real x = p.x;
    //# stub: real y = p.y;
    //# stub: real z = p.z;
    //# end
    return real3(x, y, z);
}

// The hit of a triangle with the sheared corners p, q and r, from the areas that the origin cuts
// off opposite to each.
Hit watertight_hit(PreparedRay ray, real3 p, real3 q, real3 r, real3 areas, int triangle) {
    real zero = real(0.0f);
    precise real det = areas.x + areas.y + areas.z;
    bool none_negative = areas.x >= zero && areas.y >= zero && areas.z >= zero;
    bool none_positive = areas.x <= zero && areas.y <= zero && areas.z <= zero;
    bool inside = (none_negative || none_positive) && det != zero;

    // Shares before distances: an area times a length could be too large for the numbers at hand.
    precise real share = areas.x / det;
    precise real u = areas.y / det;
    precise real v = areas.z / det;
    precise real t = share * p.z + u * q.z + v * r.z;
    bool on_ray = t >= ray.t_min && t <= ray.t_max;

    // Rounding may bring u + v over 1 by a hair; 1 - u is the most that v can be. (Precise, or a
    // compiler may take the least of both, and of two zeros the one or the other.)
    precise real most = real(1.0f) - u;
    precise real least = v < most ? v : most;

    Hit hit;
    hit.t = t;
    hit.u = u;
    hit.v = least;
    hit.triangle = inside && on_ray ? triangle : no_triangle;
    return hit;
}
