// The point at the ray's origin, moved along a normal, which is the direction.
#include "offset/surface_point.glsl"

#include "offset/waechter_binder.glsl"

uvec4 checkpoint(Ray ray, int step) {
    SurfacePoint from;
    from.a = ray.origin;
    from.b = ray.origin;
    from.c = ray.origin;
    from.point = ray.origin;
    from.normal = ray.direction;
    return bits_of_point(leaving_point(from), 0);
}
