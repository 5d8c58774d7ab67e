// The ray through the point (direction.x, direction.y) of a view that stands askew.

uvec4 checkpoint(Ray ray, int step) {
    View view;
    view.eye = ray.origin;
    view.lower_left = real3(real(-1.0f), real(-0.75f), real(-2.0f));
    view.right = real3(real(2.0f), real(0.125f), real(0.25f));
    view.up = real3(real(-0.0625f), real(1.5f), real(0.5f));
    Ray made = primary_ray(view, ray.direction.x, ray.direction.y);
    return bits_of_point(made.direction, 0);
}
