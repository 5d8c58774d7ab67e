// Diffuse light: (N.L)C, the cosine clamped at zero.
// Source: Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010,
// section 2.2.

// Whether the light stands before the surface: before the plane of the triangle, and before the
// interpolated normal's too. Where it does not, no shadow ray is needed.
bool faces_light(Surface surface, real3 light_position) {
    real3 to_light = light_position - surface.origin;
    return dot_product(surface.normal, to_light) > real(0.0f) &&
           dot_product(surface.geometric_normal, to_light) > real(0.0f);
}

real3 diffuse_light(Surface surface, real3 light_position, real3 light_color) {
    real cosine = dot_product(surface.normal, unit(light_position - surface.origin));
    precise real3 light = surface.material.diffuse * light_color * cosine;
    return light;
}
