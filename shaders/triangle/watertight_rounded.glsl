// The watertight test as its authors published it, with areas that are rounded. Rounding never
// turns a sign round: of two products, the greater rounds to no less than the smaller. So an area
// can become zero, which counts as inside, but never wrong, and nothing leaks. But where the ray
// grazes the triangle, little is left of the areas' digits, and t can lie anywhere along it.
#include "triangle/watertight/shear.glsl"

real rounded_area(real3 a, real3 b) {
    precise real area = a.x * b.y - a.y * b.x;
    return area;
}

Hit intersect_triangle(PreparedRay ray, real3 a, real3 b, real3 c, int triangle) {
    real3 p = sheared(ray, a);
    real3 q = sheared(ray, b);
    real3 r = sheared(ray, c);
    real3 areas = real3(rounded_area(q, r), rounded_area(r, p), rounded_area(p, q));
    return watertight_hit(ray, p, q, r, areas, triangle);
}
