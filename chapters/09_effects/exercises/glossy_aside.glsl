// The highlight of a lamp at the point `direction` on a surface at the ray's origin, which lies
// askew, for an eye that looks from the side: with a dull gloss, and in step 2 with a sharp one.
#include "light/highlight.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Surface surface;
    surface.origin = ray.origin;
    surface.normal = real3(real(0.48f), -real(0.6f), real(0.64f));
    surface.geometric_normal = real3(real(0.6f), real(0.0f), real(0.8f));
    Gloss gloss;
    gloss.color = real3(real(1.0f), real(0.125f), real(0.75f));
    gloss.exponent = real(step == 1 ? 1.0f : 24.0f);
    real3 look = real3(real(0.3f), real(1.5f), -real(2.5f));
    real3 light_color = real3(real(1.0f), real(3.0f), real(5.0f));
    return bits_of_point(highlight(surface, look, ray.direction, light_color, gloss), 0);
}
