// A thin lens: all rays of a pixel meet in one point of the sharp plane, and start on a disc.
// Source: Cook, Porter and Carpenter, "Distributed Ray Tracing", 1984.

// The ray of the pinhole, moved to that point of the lens. Its direction has the length 1 along the
// line of sight, so the sharp plane is at t = focus_distance. A lens of radius 0 changes nothing.
Ray lens_ray(Ray ray, View view, real radius, real focus_distance, SquarePoint on_disc) {
    //# exercise 9.6: a ray through a lens
    real3 right = unit(view.right);
    real3 up = unit(view.up);
    precise real3 aside = radius * (on_disc.x * right + on_disc.y * up);
    precise real3 origin = ray.origin + aside;
    precise real3 direction = ray.direction - aside / focus_distance;
    //# stub: real3 origin = ray.origin;
    //# stub: real3 direction = ray.direction;
    //# end
    Ray moved;
    moved.origin = origin;
    moved.direction = direction;
    moved.t_min = ray.t_min;
    moved.t_max = ray.t_max;
    return moved;
}
