// The ray to a light at the point `direction`. Step 2: from the other surface. Steps 3 and 4: in a
// very small and a very large scene. Step 5: with the light in the surface's plane.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step == 3 || step == 4 ? step - 1 : 1);
    Surface surface = surface_of(ray);
    if (step == 2) {
        surface = other_surface_of(ray);
    }
    real3 light = ray.direction;
    light.z = step == 5 ? surface.origin.z : light.z;
    surface.origin = scale * surface.origin;
    Ray shadow = shadow_ray(surface, scale * light);
    also = bits_of_point(shadow.origin / scale, shadow.t_max);
    return bits_of_point(shadow.direction / scale, shadow.t_min);
}
