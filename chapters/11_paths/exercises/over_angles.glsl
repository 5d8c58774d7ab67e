// The density of a lamp's points per unit of angle: the way to the lamp is the origin, its normal
// the direction, made as long as 1. Per unit of area it is 0.5, in step 2 it is 4.
#include "light/path.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real over_area = step == 2 ? real(4.0f) : real(0.5f);
    return uvec4(bits(density_over_angles(over_area, ray.origin, unit(ray.direction))), 0u, 0u, 0u);
}
