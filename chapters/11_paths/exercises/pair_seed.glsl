// The seed of a pair of numbers in a pixel: both are whole numbers, the origin's x and y without
// sign and fraction. The picture's own seed is 0.
#include "light/hash.glsl"

uvec4 checkpoint(Ray ray, int step) {
    int pixel = int(floor(abs(ray.origin.x)));
    int pair = int(floor(abs(ray.origin.y)));
    uint made = seed_of_pair(pixel, pair);
    return uvec4(made >> 16u, made & 0xFFFFu, 0u, 0u);
}
