// From where to where the ray to a light at the point `direction` goes.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Ray shadow = shadow_ray(surface_of(ray), ray.direction);
    return uvec4(bits(shadow.t_min), bits(shadow.t_max), shadow.t_max < real(1.0f) ? 1u : 0u,
                 is_empty(shadow) ? 1u : 0u);
}
