// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), seen by the ray.

Hit hit_of_unit_triangle(Ray ray) {
    return intersect_triangle(prepare_ray(ray), real3(real(0.0f)),
                              real3(real(1.0f), real(0.0f), real(0.0f)),
                              real3(real(0.0f), real(1.0f), real(0.0f)), 7);
}
