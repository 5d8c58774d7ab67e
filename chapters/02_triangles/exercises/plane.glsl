// Where the ray meets the plane of a triangle, be it inside the triangle or not.
// Step 1: the unit triangle. Step 2: one that stands askew. Steps 3 and 4: that one very small and
// very large, with everything else. Step 5: the unit triangle, and a very short direction.

real scaled_end(real t, real scale) {
    return abs(t) == real(farthest) ? t : scale * t;
}

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step - 1);
    real3 a = real3(real(0.0f));
    real3 b = real3(real(1.0f), real(0.0f), real(0.0f));
    real3 c = real3(real(0.0f), real(1.0f), real(0.0f));
    if (step >= 2 && step <= 4) {
        a = scale * real3(real(0.25f), real(-0.5f), real(1.0f));
        b = scale * real3(real(1.5f), real(0.25f), real(0.5f));
        c = scale * real3(real(-0.5f), real(1.0f), real(0.75f));
        ray.origin = scale * ray.origin;
        ray.t_min = scaled_end(ray.t_min, scale);
        ray.t_max = scaled_end(ray.t_max, scale);
    }
    if (step == 5) {
        scale = real(1.2676506002282294e30f); // 2^100
        ray.direction = ray.direction / scale;
        ray.t_min = scaled_end(ray.t_min, scale);
        ray.t_max = scaled_end(ray.t_max, scale);
    }
    Hit hit = intersect_triangle(prepare_ray(ray), a, b, c, 7);
    return uvec4(bits(hit.t / scale), bits(hit.u), bits(hit.v), uint(hit.triangle));
}
