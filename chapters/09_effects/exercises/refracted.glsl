// The direction behind the surface, of a ray of length 1 and a normal against it. Where the sine
// behind would be 1 or nearly so, nothing is asked: the reflection is total.
#include "glass_meeting.glsl"
#include "light/fresnel.glsl"

const float greatest_sine = 0.999f;

uvec4 checkpoint(Ray ray, int step) {
    Indices indices = indices_of(step);
    real3 direction = unit(ray.direction);
    real3 normal = unit(ray.origin);
    normal = dot_product(normal, direction) > real(0.0f) ? -normal : normal;
    real cosine = cosine_of(ray);
    real sine_behind = indices.before / indices.behind * sqrt(real(1.0f) - cosine * cosine);
    if (sine_behind > real(greatest_sine)) {
        return uvec4(0u, 0u, 0u, 1u);
    }
    return bits_of_point(refracted_direction(direction, normal, indices.before, indices.behind), 0);
}
