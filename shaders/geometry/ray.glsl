// What is asked of every ray.

real3 point_at(Ray ray, real t) {
    precise real3 point = ray.origin + t * ray.direction;
    return point;
}

// A ray without a point: it hits nothing, and no walk has to be made for it.
bool is_empty(Ray ray) {
    return ray.t_max < ray.t_min;
}
