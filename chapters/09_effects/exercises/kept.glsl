// What glass leaves of red, green and blue light after a way as long as the ray's direction.
#include "light/absorption.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real distance_in_glass = sqrt(dot_product(ray.direction, ray.direction));
    real3 transmission = real3(real(0.5f), real(0.25f), real(1.0f));
    return bits_of_point(transmitted(transmission, distance_in_glass), 0);
}
