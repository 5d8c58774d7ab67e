// Whether the surface faces a light at the point `direction`.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    return uvec4(faces_light(surface_of(ray), ray.direction) ? 1u : 0u, 0u, 0u, 0u);
}
