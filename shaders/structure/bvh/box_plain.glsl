// Does the ray meet the box at or before t_max? Equal counts: a hit at t_max itself may still win
// by its number, and a flat box is as thick as a point. Boxes that a builder has padded need no
// more than that (structure/bvh/box_ray.glsl). Source: Kay and Kajiya, "Ray Tracing Complex
// Scenes", 1986.

bool meets_box(BoxRay ray, real3 first_planes, real3 last_planes, real t_max) {
    BoxSpan span = span_in_box(ray, first_planes, last_planes, t_max);
    return span.entry <= span.exit;
}
