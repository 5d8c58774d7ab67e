// Diffuse light: (N.L)C. A light that the surface does not face adds nothing, and is not asked for:
// so the cosine needs no clamp.
// Source: Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010,
// section 2.2.

// Whether the light stands before the surface: before the plane of the triangle, and before the
// interpolated normal's too. Where it does not, no shadow ray is needed.
bool faces_light(Surface surface, real3 light_position) {
    real3 to_light = light_position - surface.origin;
    //# exercise 3.1: does the surface face the light
    return dot_product(surface.normal, to_light) > real(0.0f) &&
           dot_product(surface.geometric_normal, to_light) > real(0.0f);
    //# stub: return false;
    //# end
}

real3 diffuse_light(Surface surface, real3 light_position, real3 light_color) {
    //# exercise 3.2: diffuse light
    real cosine = dot_product(surface.normal, unit(light_position - surface.origin));
    precise real3 light = surface.material.diffuse * light_color * cosine;
    //# stub: real3 light = real3(real(0.0f));
    //# end
    return light;
}
