// The direction of the ray to a light at the point `direction`.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_point(shadow_ray(surface_of(ray), ray.direction).direction, 0);
}
