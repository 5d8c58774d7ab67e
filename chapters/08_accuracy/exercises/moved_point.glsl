// The point at the ray's origin, moved along a normal, which is the direction, with components from
// -1 to 1. In step 2 the point is 1 / 32 and the numbers on both sides of it, in step 3 minus
// these; in step 4 it lies where units in the last place change their size, and in step 5 at
// numbers that are nearly zero.
#include "offset/surface_point.glsl"

#include "offset/waechter_binder.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real edge = real(near_zero);
    real3 edges = real3(just_below(edge), edge, just_above(edge));
    SurfacePoint from;
    from.point = step == 2   ? edges
                 : step == 3 ? -edges
                 : step == 4 ? real3(real(1.0f), -real(1.0f), just_below(real(2.0f)))
                 : step == 5 ? real3(real(0.0f), real(least_number), -real(1e-6f))
                             : ray.origin;
    from.a = from.point;
    from.b = from.point;
    from.c = from.point;
    from.normal = clamp(ray.direction, real3(-real(1.0f)), real3(real(1.0f)));
    return bits_of_point(leaving_point(from), 0);
}
