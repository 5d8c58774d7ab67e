// The ray through one of three points of a lens of the radius 0.5 that is sharp at the distance 4.
#include "light/samples.glsl"

#include "light/lens.glsl"

Ray through_lens(Ray ray, int step) {
    View view;
    view.eye = ray.origin;
    view.lower_left = real3(-real(1.0f), -real(1.5f), -real(1.0f));
    view.right = real3(real(2.0f), real(0.0f), real(0.0f));
    view.up = real3(real(0.0f), real(3.0f), real(0.0f));
    SquarePoint on_disc;
    on_disc.x = step == 1 ? real(1.0f) : step == 2 ? real(0.0f) : -real(0.5f);
    on_disc.y = step == 1 ? real(0.0f) : step == 2 ? -real(1.0f) : real(0.25f);
    return lens_ray(ray, view, real(0.5f), real(4.0f), on_disc);
}
