// The direction behind the surface where a ray leaves glass at the critical angle, or as near to it
// as numbers are: the cosine is the nearest number to the root of 5 / 9 in step 1, the one below it
// in step 2, and the one above it in step 3. The ray's direction turns it about the normal.
#include "light/fresnel.glsl"

const float critical_cosine = 0.7453559637069702f;

uvec4 checkpoint(Ray ray, int step) {
    real cosine = real(critical_cosine);
    cosine = step == 2 ? just_below(cosine) : step == 3 ? just_above(cosine) : cosine;
    real3 aside = unit(real3(ray.direction.x, ray.direction.y, real(0.0f)));
    real3 normal = real3(real(0.0f), real(0.0f), real(1.0f));
    real3 direction = sqrt(real(1.0f) - cosine * cosine) * aside - cosine * normal;
    return bits_of_point(refracted_direction(direction, normal, real(1.5f), real(1.0f)), 0);
}
