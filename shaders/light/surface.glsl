// What a ray finds where it hits: the point, the normals on its own side, and the material.

struct Surface {
    real3 origin;           // of rays that leave: the point, moved off the triangle
    real3 geometric_normal; // of the triangle's plane
    real3 normal;           // interpolated between the corners
    Material material;
};

Surface surface_at(Ray ray, Hit hit) {
    real3 a = triangle_corner(hit.triangle, 0);
    real3 b = triangle_corner(hit.triangle, 1);
    real3 c = triangle_corner(hit.triangle, 2);
    precise real3 point = a + hit.u * (b - a) + hit.v * (c - a);

    precise real weight_a = real(1.0f) - hit.u - hit.v;
    precise real3 normal = weight_a * triangle_normal(hit.triangle, 0) +
                           hit.u * triangle_normal(hit.triangle, 1) +
                           hit.v * triangle_normal(hit.triangle, 2);

    // Corners on one line span no plane. Such a triangle closes a slit between others, whose
    // normals it has.
    real3 upright = cross_product(b - a, c - a);
    upright = is_zero(upright) ? normal : upright;
    real3 geometric = unit(is_zero(upright) ? ray.direction : upright);
    geometric = dot_product(geometric, ray.direction) > real(0.0f) ? -geometric : geometric;

    // Opposite normals can cancel out: then the plane's own has to do.
    normal = dot_product(normal, normal) > real(0.0f) ? unit(normal) : geometric;
    normal = dot_product(normal, geometric) < real(0.0f) ? -normal : normal;

    //# exercise 3.5: leaving a surface
    precise real3 origin = point + leaving_distance(a, b, c) * geometric;
    //# stub: real3 origin = point;
    //# end
    Surface surface;
    surface.origin = origin;
    surface.geometric_normal = geometric;
    surface.normal = normal;
    surface.material = triangle_material(hit.triangle);
    return surface;
}
