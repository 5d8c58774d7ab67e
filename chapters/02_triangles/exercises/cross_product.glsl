// The cross product of the ray's origin and its direction.

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_point(cross_product(ray.origin, ray.direction), 0);
}
