// Whether there is any highlight at all of the lamp at the point `direction`, where the eye looks
// straight down on a flat surface at the ray's origin.
#include "light/highlight.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Surface surface;
    surface.origin = ray.origin;
    surface.normal = real3(real(0.0f), real(0.0f), real(1.0f));
    surface.geometric_normal = surface.normal;
    Gloss gloss;
    gloss.color = real3(real(1.0f));
    gloss.exponent = real(4.0f);
    real3 look = real3(real(0.0f), real(0.0f), -real(1.0f));
    real3 light = highlight(surface, look, ray.direction, real3(real(1.0f)), gloss);
    uint lit = 0u;
    if (light != real3(real(0.0f))) {
        lit = 1u;
    }
    return uvec4(lit, 0u, 0u, 0u);
}
