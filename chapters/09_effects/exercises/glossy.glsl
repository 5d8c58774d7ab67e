// The highlight of a lamp at the point `direction` on a surface at the ray's origin, which lies
// flat. The eye looks down on it in step 1, and up from below in step 2.
#include "light/highlight.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Surface surface;
    surface.origin = ray.origin;
    surface.normal = real3(real(0.0f), real(0.0f), real(1.0f));
    surface.geometric_normal = real3(real(0.6f), real(0.0f), real(0.8f));
    Gloss gloss;
    gloss.color = real3(real(0.5f), real(0.25f), real(1.0f));
    gloss.exponent = real(4.0f);
    real3 look = real3(real(0.0f), real(0.0f), step == 1 ? -real(2.0f) : real(2.0f));
    real3 light_color = real3(real(2.0f), real(4.0f), real(1.0f));
    return bits_of_point(highlight(surface, look, ray.direction, light_color, gloss), 0);
}
