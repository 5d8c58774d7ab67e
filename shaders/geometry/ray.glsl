// What is asked of every ray.

// A ray without a point: it hits nothing, and no walk has to be made for it.
bool is_empty(Ray ray) {
    return ray.t_max < ray.t_min;
}
