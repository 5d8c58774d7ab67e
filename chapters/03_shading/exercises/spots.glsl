// What a lit point of the scene sees of a lamp above: whether the ray to it is blocked, and by
// which triangle. A triangle that blocks its own ray is acne.
uniform vec3 lamp;

uvec4 checkpoint(Ray ray, int step) {
    Hit hit = closest_hit(ray);
    if (!is_hit(hit)) {
        return uvec4(uint(no_triangle), 0u, uint(no_triangle), 0u);
    }
    Ray to_lamp = shadow_ray(surface_at(ray, hit), real3(lamp));
    Hit blocking = closest_hit(to_lamp);
    return uvec4(uint(hit.triangle), is_hit(blocking) ? 1u : 0u, uint(blocking.triangle), 0u);
}
