// The axis of the least of three numbers: those of the origin.

uvec4 checkpoint(Ray ray, int step) {
    return uvec4(uint(first_axis(ray.origin)), 0u, 0u, 0u);
}
