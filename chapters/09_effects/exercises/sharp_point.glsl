// Where the ray through the lens is in the sharp plane.
#include "lens.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Ray moved = through_lens(ray, step);
    return bits_of_point(moved.origin + real(4.0f) * moved.direction, 0);
}
