// The ray's direction, reflected about the unit vector along its origin; in steps 2 to 4 a very
// short and a very long one.

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step);
    real3 reflected = reflect_about(scale * ray.direction, unit(ray.origin));
    return bits_of_point(reflected / scale, 0);
}
