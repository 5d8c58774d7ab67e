// Where the ray leaves the box of a node, and through which face. Step n asks of node n - 1; from
// step 13 on, of the first nodes again, with a ray from the point 0 to a corner: it meets two
// planes at the same t, or three.

real towards(real lower, real upper) {
    return upper > real(0.0f) ? upper : lower;
}

uvec4 checkpoint(Ray ray, int step) {
    int place = (step - 1) % 12;
    if (step > 12) {
        real3 lower = kd_box_lower(place);
        real3 upper = kd_box_upper(place);
        real3 corner =
            real3(towards(lower.x, upper.x), towards(lower.y, upper.y), towards(lower.z, upper.z));
        int odd = int(floor(real(4.0f) * fract(abs(ray.origin.x))));
        if (odd < 3) {
            corner[odd] = real(0.5f) * corner[odd];
        }
        ray.origin = real3(real(0.0f));
        ray.direction = real(0.25f) * corner;
    }
    KdExit exit = box_exit(place, ray);
    return uvec4(bits(exit.t), uint(exit.face), uint(place), 0u);
}
