// The interpolated normal as a colour, darker where the surface turns away.

vec3 color_of_hit(Ray ray, Hit hit) {
    Surface surface = surface_at(ray, hit);
    float facing = abs(dot(vec3(surface.normal), normalize(vec3(ray.direction))));
    return color_of_direction(vec3(surface.normal)) * (0.25f + 0.75f * facing);
}
