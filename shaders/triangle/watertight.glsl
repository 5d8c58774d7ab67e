// Where does this ray meet this triangle? Watertight: a ray that is aimed at an edge or a corner of
// a closed mesh hits one of the triangles that share it. The areas are computed without an error
// that counts, so the shares, and t with them, are right even where the ray grazes the triangle or
// the triangle is a sliver: the hit always lies at the triangle. Structures rely on that (see
// common/structure/padding.h).
#include "triangle/watertight/shear.glsl"
#include "triangle/watertight/exact_area.glsl"

Hit intersect_triangle(PreparedRay ray, real3 a, real3 b, real3 c, int triangle) {
    //# exercise 8.5: a hunt, for a leak
    real3 p = sheared(ray, a);
    real3 q = sheared(ray, b);
    real3 r = sheared(ray, c);
    Halves px = halves(p.x);
    Halves py = halves(p.y);
    Halves qx = halves(q.x);
    Halves qy = halves(q.y);
    Halves rx = halves(r.x);
    Halves ry = halves(r.y);
    real area_a = exact_area(q, r, qx, qy, rx, ry);
    real area_b = exact_area(r, p, rx, ry, px, py);
    real area_c = exact_area(p, q, px, py, qx, qy);
    return watertight_hit(ray, p, q, r, real3(area_a, area_b, area_c), triangle);
    //# end
}
