// The watertight test with rounded areas, and in double where one of them is zero: the form in
// which its authors use it, since a zero may stand for a small area of either sign. It decides more
// sharply who of two neighbours has an edge; nothing leaked without it. What it says of t where the
// ray grazes a triangle is as weak as before.
#include "triangle/watertight/shear.glsl"

real rounded_area(real3 a, real3 b) {
    precise real area = a.x * b.y - a.y * b.x;
    return area;
}

// Products of two floats are exact in double.
real area_in_double(real3 a, real3 b) {
    precise double area = double(a.x) * double(b.y) - double(a.y) * double(b.x);
    return real(area);
}

Hit intersect_triangle(PreparedRay ray, real3 a, real3 b, real3 c, int triangle) {
    real3 p = sheared(ray, a);
    real3 q = sheared(ray, b);
    real3 r = sheared(ray, c);
    real3 areas = real3(rounded_area(q, r), rounded_area(r, p), rounded_area(p, q));
    if (areas.x == real(0.0f) || areas.y == real(0.0f) || areas.z == real(0.0f)) {
        areas = real3(area_in_double(q, r), area_in_double(r, p), area_in_double(p, q));
    }
    return watertight_hit(ray, p, q, r, areas, triangle);
}
