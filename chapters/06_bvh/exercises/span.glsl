// The part of the ray in the box from (0, 0, 0) to (1, 2, 3); in step 2, between planes that a ray
// with t_min and t_max enters at the three numbers of the origin, and leaves at those of the
// direction.

uvec4 checkpoint(Ray ray, int step) {
    BoxRay prepared = box_ray(ray);
    real3 lower = real3(real(0.0f));
    real3 upper = real3(real(1.0f), real(2.0f), real(3.0f));
    real3 first =
        real3(descends(prepared, 0) ? upper.x : lower.x, descends(prepared, 1) ? upper.y : lower.y,
              descends(prepared, 2) ? upper.z : lower.z);
    real3 last = lower + upper - first;
    if (step == 2) {
        prepared.first_origin = real3(real(0.0f));
        prepared.last_origin = prepared.first_origin;
        prepared.inverse = real3(real(1.0f));
        first = ray.origin;
        last = ray.direction;
    }
    BoxSpan span = span_in_box(prepared, first, last, ray.t_max);
    return uvec4(bits(span.entry), bits(span.exit), span.entry <= span.exit ? 1u : 0u, 0u);
}
