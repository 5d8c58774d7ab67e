// Whether a box is met whose planes the ray enters and leaves at given t: those are the planes of a
// ray from the zero point in the direction (1, 1, 1), of which t begins at t_min.
#include "slab/padded.glsl"

uvec4 checkpoint(Ray ray, int step) {
    BoxRay diagonal;
    diagonal.first_origin = real3(real(0.0f));
    diagonal.last_origin = real3(real(0.0f));
    diagonal.inverse = real3(real(1.0f));
    diagonal.t_min = ray.t_min;
    return uvec4(meets_box(diagonal, ray.origin, ray.direction, ray.t_max) ? 1u : 0u, 0u, 0u, 0u);
}
