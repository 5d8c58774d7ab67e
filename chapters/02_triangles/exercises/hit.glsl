// The hit of the ray with the unit triangle, whose number is 7.
#include "unit_triangle.glsl"

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_hit(hit_of_unit_triangle(ray));
}
