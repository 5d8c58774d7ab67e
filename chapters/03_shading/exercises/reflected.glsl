// The ray's direction, reflected about the unit vector along its origin.

uvec4 checkpoint(Ray ray, int step) {
    return bits_of_point(reflect_about(ray.direction, unit(ray.origin)), 0);
}
