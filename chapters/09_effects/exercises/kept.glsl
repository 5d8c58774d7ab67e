// What glass leaves of red, green and blue light after a way as long as the ray's direction. In
// step 2 it is nearly clear for red, and lets no green through.
#include "light/absorption.glsl"

uvec4 checkpoint(Ray ray, int step) {
    real way = sqrt(dot_product(ray.direction, ray.direction));
    real3 transmission = real3(real(0.5f), real(0.25f), real(1.0f));
    if (step == 2) { // no way through what lets nothing through is no question
        transmission.x = real(0.9995f);
        transmission.y = way > real(0.0f) ? real(0.0f) : transmission.y;
    }
    return bits_of_point(transmitted(transmission, way), 0);
}
