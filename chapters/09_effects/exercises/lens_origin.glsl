// Where the ray starts on the lens.
#include "lens.glsl"

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_point(through_lens(ray, step).origin, 0);
}
