// The ray that tests whether anything stands between a surface and a light.

// The last part of the way is the lamp's own: what is hit there is the lamp, not something before
// it.
const float lamp_part = 1.52587890625e-5f; // 2^-16

// From the surface (t = 0) towards the light (t = 1); an empty ray where the light is behind.
Ray shadow_ray(Surface surface, real3 light_position) {
    Ray ray;
    ray.origin = surface.origin;
    //# exercise 3.3: the ray to a light
    ray.direction = light_position - surface.origin;
    ray.t_min = real(0.0f);
    ray.t_max = faces_light(surface, light_position) ? real(1.0f - lamp_part) : -real(1.0f);
    //# stub: ray.direction = real3(real(1.0f));
    //# stub: ray.t_min = real(0.0f);
    //# stub: ray.t_max = -real(1.0f);
    //# end
    return ray;
}
