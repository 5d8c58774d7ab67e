// The cross product of the ray's origin and its direction; in steps 2 to 4 of very small and very
// large ones.

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step);
    return bits_of_point(cross_product(scale * ray.origin, scale * ray.direction) / (scale * scale),
                         0);
}
