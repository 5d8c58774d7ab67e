// The nearest hit of the ray with the scene.

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_hit(closest_hit(ray));
}
