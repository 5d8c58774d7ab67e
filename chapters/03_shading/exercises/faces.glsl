// Whether the surface faces a light at the point `direction`. Steps 2 to 4 ask it of a very small
// and a very large scene, step 5 of the other surface. Steps 6 and 7 put the light into the plane
// of the interpolated normal, and into the triangle's.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step);
    bool is_other = step == 5 || step == 6;
    real3 light = scale * ray.direction;
    ray.origin = scale * ray.origin;
    if (step == 6) {
        light.y = ray.origin.y;
    } else if (step == 7) {
        light.z = ray.origin.z;
    }
    Surface surface = surface_of(ray);
    if (is_other) {
        surface = other_surface_of(ray);
    }
    return uvec4(faces_light(surface, light) ? 1u : 0u, 0u, 0u, 0u);
}
