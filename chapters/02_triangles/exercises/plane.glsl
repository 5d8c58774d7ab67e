// Where the ray meets the plane of the unit triangle, be it inside the triangle or not.
#include "unit_triangle.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Hit hit = hit_of_unit_triangle(ray);
    return uvec4(bits(hit.t), bits(hit.u), bits(hit.v), 0u);
}
