// In which direction the ray leaves the lens.
#include "lens.glsl"

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_point(through_lens(ray, step).direction, 0);
}
