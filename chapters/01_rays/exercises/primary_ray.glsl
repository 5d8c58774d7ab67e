// The ray through the point (direction.x, direction.y) of a view that stands askew. In step 2 its
// axes are turned round; in steps 3 and 4 it is very small and very large.

real3 turned(real3 a) {
    return real3(a.z, a.x, a.y);
}

uvec4 checkpoint(Ray ray, int step) {
    real scale = scale_of(step - 1);
    View view;
    view.eye = ray.origin;
    view.lower_left = scale * real3(real(-1.0f), real(-0.75f), real(-2.0f));
    view.right = scale * real3(real(2.0f), real(0.125f), real(0.25f));
    view.up = scale * real3(real(-0.0625f), real(1.5f), real(0.5f));
    if (step == 2) {
        view.lower_left = turned(view.lower_left);
        view.right = turned(view.right);
        view.up = turned(view.up);
    }
    Ray made = primary_ray(view, ray.direction.x, ray.direction.y);
    also = bits_of_point(made.origin, made.t_max);
    return bits_of_point(made.direction / scale, made.t_min);
}
