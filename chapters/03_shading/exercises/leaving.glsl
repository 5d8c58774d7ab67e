// How far a ray is moved that leaves a triangle, in units of 64 e: the corners are the origin, the
// direction, and (t_min, t_max, 0).

uvec4 checkpoint(Ray ray, int step) {
    real off = leaving_distance(ray.origin, ray.direction, real3(ray.t_min, ray.t_max, real(0.0f)));
    return uvec4(bits(off * real(262144.0f)), 0u, 0u, 0u);
}
