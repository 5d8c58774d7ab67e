// The ray through a lens of a camera that stands askew, somewhere else than where the ray starts:
// its direction, and its origin. In step 3 the lens has the radius 0.
#include "light/samples.glsl"

#include "light/lens.glsl"

uvec4 checkpoint(Ray ray, int step) {
    View view;
    view.eye = real3(real(7.0f), -real(5.0f), real(3.0f));
    view.right = real3(real(1.2f), real(1.6f), real(0.0f));
    view.up = real3(-real(0.48f), real(0.36f), real(0.8f));
    view.lower_left = view.eye;
    SquarePoint on_disc;
    on_disc.x = step == 1 ? real(0.6f) : -real(0.3f);
    on_disc.y = step == 1 ? -real(0.5f) : real(0.7f);
    Ray moved = lens_ray(ray, view,
                         real(step == 1   ? 0.25f
                              : step == 2 ? 2.0f
                                          : 0.0f),
                         real(step == 1 ? 2.5f : 0.75f), on_disc);
    also = bits_of_point(moved.origin, 0);
    return bits_of_point(moved.direction, 0);
}
