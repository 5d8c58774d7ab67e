// Which of two hits wins: one at t = origin.x of triangle origin.y, and the best so far, at t =
// direction.x of triangle direction.y. Numbers below zero are no triangles.

uvec4 checkpoint(Ray ray, int step) {
    Hit hit;
    hit.t = ray.origin.x;
    hit.u = real(0.0f);
    hit.v = real(0.0f);
    hit.triangle = int(floor(ray.origin.y));
    Hit best = hit;
    best.t = ray.direction.x;
    best.triangle = int(floor(ray.direction.y));
    return uvec4(is_nearer(hit, best) ? 1u : 0u, 0u, 0u, 0u);
}
