// The rectangle that a picture looks through, one length of the view direction before the eye.
// The point at (s, t) of it, each from 0 to 1, lies at eye + lower_left + s * right + t * up.
struct View {
    real3 eye;
    real3 lower_left;
    real3 right;
    real3 up;
};

// The ray through the point (s, t) of the view; (0, 0) is the lower left corner of the picture.
// Its direction is not normalised: t counts depths of the view rectangle, not lengths.

Ray primary_ray(View view, real s, real t) {
    //# exercise 1.1: the direction through a point of the view
    precise real3 direction = view.lower_left + s * view.right + t * view.up;
    //# stub: real3 direction = view.lower_left;
    //# end
    Ray ray;
    ray.origin = view.eye;
    ray.direction = direction;
    ray.t_min = real(0.0f);
    ray.t_max = real(farthest);
    return ray;
}
