// Which of two triangles the ray hits, and where it hits the first one. They share the edge from
// (1, 0, 0) to (0, 1, 0), which they run along in opposite directions. The steps make all smaller
// and larger, with the ray's origin (see scale_of in probes.glsl).

Hit hit_between(Ray ray, real3 a, real3 b, real3 c) {
    return intersect_triangle(prepare_ray(ray), a, b, c, 7);
}

uvec4 checkpoint(Ray ray, int step) {
    real size = scale_of(step);
    ray.origin = size * ray.origin;
    real3 zero = real3(real(0.0f));
    real3 right = real3(size, real(0.0f), real(0.0f));
    real3 up = real3(real(0.0f), size, real(0.0f));
    Hit first = hit_between(ray, zero, right, up);
    Hit second = hit_between(ray, right + up, up, right);
    also.x = is_hit(second) ? bits(second.u) : 0u;
    also.y = is_hit(second) ? bits(second.v) : 0u;
    return uvec4(is_hit(first) ? 1u : 0u, is_hit(second) ? 1u : 0u,
                 is_hit(first) ? bits(first.u) : 0u, is_hit(first) ? bits(first.v) : 0u);
}
