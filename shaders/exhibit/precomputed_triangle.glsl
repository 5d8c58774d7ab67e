// Where does this ray meet this triangle? From a map that was computed beforehand
// (exhibit/transforms.glsl), so that the corners are not needed. Fast, and each triangle rounds its
// edges by itself: not watertight. No part of the slot <triangle>, since only those who upload the
// maps can use it. Source: Baldwin and Weber, "Fast Ray-Triangle Intersections by Coordinate
// Transformation", 2016.
#include "exhibit/transforms.glsl"

struct PreparedRay {
    Ray ray;
};

PreparedRay prepare_ray(Ray ray) {
    PreparedRay prepared;
    prepared.ray = ray;
    return prepared;
}

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    Ray ray = prepared.ray;
    vec4 row_u = triangle_transform(triangle, 0);
    vec4 row_v = triangle_transform(triangle, 1);
    vec4 row_w = triangle_transform(triangle, 2);
    precise real height = dot_product(real3(row_w), ray.origin) + real(row_w.w);
    precise real t = -height / dot_product(real3(row_w), ray.direction);
    precise real3 point = ray.origin + t * ray.direction;
    precise real u = dot_product(real3(row_u), point) + real(row_u.w);
    precise real v = dot_product(real3(row_v), point) + real(row_v.w);
    bool inside = u >= real(0.0f) && v >= real(0.0f) && u + v <= real(1.0f);
    bool on_ray = t >= ray.t_min && t <= ray.t_max;

    Hit hit;
    hit.t = t;
    hit.u = u;
    hit.v = v;
    hit.triangle = inside && on_ray ? triangle : no_triangle;
    return hit;
}
