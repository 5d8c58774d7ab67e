// As little as rounding allows, by a bound: the way of chapter 03.
#include "light/leave_surface.glsl"

const float leaving_t_min = 0.0f;

real3 leaving_point(SurfacePoint from) {
    precise real3 moved = from.point + leaving_distance(from.a, from.b, from.c) * from.normal;
    return moved;
}
