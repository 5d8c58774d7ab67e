// How a ray leaves the scene's nearest triangle: by how much its origin stands off the point of the
// triangle, in leaving distances; and whether the normals are as they were.

uvec4 checkpoint(Ray ray, int step) {
    Hit hit = closest_hit(ray);
    if (!is_hit(hit)) {
        return uvec4(0u, 0u, 0u, uint(no_triangle));
    }
    Surface surface = surface_at(ray, hit);
    real3 a = triangle_corner(hit.triangle, 0);
    real3 b = triangle_corner(hit.triangle, 1);
    real3 c = triangle_corner(hit.triangle, 2);
    precise real3 point = a + hit.u * (b - a) + hit.v * (c - a);
    real3 off = (surface.origin - point) / leaving_distance(a, b, c);
    also = bits_of_point(surface.normal, dot_product(surface.geometric_normal, ray.direction));
    return bits_of_point(off, hit.triangle);
}
