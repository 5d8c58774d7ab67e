// Whether the origin of a ray that leaves the scene's nearest triangle stands off its plane on the
// side where the ray came from, by at least half and at most one and a half of leaving_distance.

uvec4 checkpoint(Ray ray, int step) {
    Hit hit = closest_hit(ray);
    if (!is_hit(hit)) {
        return uvec4(0u, 0u, uint(no_triangle), 0u);
    }
    Surface surface = surface_at(ray, hit);
    real3 a = triangle_corner(hit.triangle, 0);
    real3 b = triangle_corner(hit.triangle, 1);
    real3 c = triangle_corner(hit.triangle, 2);
    real off = dot_product(surface.origin - a, surface.geometric_normal);
    real distance_off = leaving_distance(a, b, c);
    return uvec4(off > real(0.5f) * distance_off ? 1u : 0u,
                 off < real(1.5f) * distance_off ? 1u : 0u, uint(hit.triangle), 0u);
}
