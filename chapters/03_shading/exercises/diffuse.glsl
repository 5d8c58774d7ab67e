// The diffuse light of a lamp at the point `direction`, of the colour (2, 3, 1); nothing where the
// surface does not face it, of which nobody asks. Step 2: of the other surface, and a lamp of the
// colour (4, 0.5, 16). Steps 3 and 4: of a very small and a very large scene.
#include "a_surface.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step > 2 ? step - 1 : 1);
    Surface surface = surface_of(ray);
    real3 color = real3(real(2.0f), real(3.0f), real(1.0f));
    if (step == 2) {
        surface = other_surface_of(ray);
        color = real3(real(4.0f), real(0.5f), real(16.0f));
    }
    surface.origin = scale * surface.origin;
    real3 light = scale * ray.direction;
    if (!faces_light(surface, light)) {
        return uvec4(0u);
    }
    return bits_of_point(diffuse_light(surface, light, color), 0);
}
