// The hit of the ray with the unit triangle, whose number is 7.
//
// From step 2 on the ray is another: it stands at right angles to the triangle, above it or below,
// where u, v and t are exactly the numbers that the steps choose.

Hit hit_of_unit_triangle(Ray ray) {
    return intersect_triangle(prepare_ray(ray), real3(real(0.0f)),
                              real3(real(1.0f), real(0.0f), real(0.0f)),
                              real3(real(0.0f), real(1.0f), real(0.0f)), 7);
}

// Its t counts lengths of the direction, which is as long as `size` says; size < 0 is downwards.
Ray upright_ray(real u, real v, real t, real size, real t_min, real t_max) {
    Ray ray;
    ray.origin = real3(u, v, -t * size);
    ray.direction = real3(real(0.0f), real(0.0f), size);
    ray.t_min = t_min;
    ray.t_max = t_max;
    return ray;
}

Ray asked_ray(Ray ray, int step) {
    real part = fract(abs(ray.origin.x));
    real rest = real(1.0f) - part;
    real t = ray.direction.y;
    real size =
        scale_of(1 + (step & 3)) * (ray.direction.z < real(0.0f) ? -real(1.0f) : real(1.0f));
    real least = real(least_number);
    real far = real(farthest);
    Ray inside = upright_ray(real(0.5f) * part, real(0.5f) * rest, t, size, -far, far);
    Ray asked = inside;
    if (step == 2) {
        asked = upright_ray(part, rest, t, size, -far, far);
    } else if (step == 3) {
        asked = upright_ray(part, just_above(rest), t, size, -far, far);
    } else if (step == 4) {
        asked = upright_ray(part, just_above(just_above(rest)), t, size, -far, far);
    } else if (step == 5) {
        asked = upright_ray(-least, part, t, size, -far, far);
    } else if (step == 6) {
        asked = upright_ray(part, -least, t, size, -far, far);
    } else if (step == 7) {
        asked = upright_ray(real(0.0f), part, t, size, -far, far);
    } else if (step == 8) {
        asked = upright_ray(part, real(0.0f), t, size, -far, far);
    } else if (step == 9) {
        asked = upright_ray(real(1.0f), real(0.0f), t, size, -far, far);
    } else if (step == 10) {
        asked.t_min = t;
        asked.t_max = t;
    } else if (step == 11) {
        asked.t_min = just_above(t);
    } else if (step == 12) {
        asked.t_max = just_below(t);
    } else if (step == 13) {
        asked.t_min = t;
    } else if (step == 14) {
        asked.t_max = t;
    } else if (step == 15) { // in the plane: u, v and t are no numbers
        asked.origin.z = real(0.0f);
        asked.direction = real3(size, real(0.0f), real(0.0f));
    } else if (step == 16) { // beside the plane: u and t are infinite
        asked.origin.z = abs(size);
        asked.direction = real3(size, real(0.0f), real(0.0f));
    } else if (step == 17) {
        asked.t_min = t + real(1.0f);
        asked.t_max = t - real(1.0f);
    } else if (step == 18) { // at the origin itself
        asked.origin.z = real(0.0f);
        asked.t_min = real(0.0f);
        asked.t_max = real(0.0f);
    }
    return asked;
}

uvec4 checkpoint(Ray ray, int step) {
    Ray asked = asked_ray(ray, step);
    Ray traced = ray;
    if (step != 1) {
        traced = asked;
    }
    Hit hit = hit_of_unit_triangle(traced);
    also = step == 1 ? uvec4(0u)
                     : uvec4(bits(asked.origin.x), bits(asked.origin.y), bits(asked.t_min),
                             bits(asked.t_max));
    return bits_of_hit(hit);
}
