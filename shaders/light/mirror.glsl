// The ray that a mirror sends on: the incoming one, turned round about the interpolated normal.

real3 reflect_about(real3 direction, real3 normal) {
    //# exercise 3.4: a reflected direction
    precise real3 reflected = direction - real(2.0f) * dot_product(normal, direction) * normal;
    //# stub: real3 reflected = direction;
    //# end
    return reflected;
}

Ray mirror_ray(Surface surface, Ray incoming) {
    real3 direction = reflect_about(incoming.direction, surface.normal);
    // An interpolated normal can send a ray into its own triangle: then the plane's normal decides.
    bool enters = dot_product(direction, surface.geometric_normal) <= real(0.0f);
    Ray ray;
    ray.origin = surface.origin;
    ray.direction =
        enters ? reflect_about(incoming.direction, surface.geometric_normal) : direction;
    ray.t_min = real(0.0f);
    ray.t_max = real(farthest);
    return ray;
}
