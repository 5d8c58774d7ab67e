// A surface at the ray's origin whose plane looks up along z, and whose normal leans to x.

Surface surface_of(Ray ray) {
    Surface surface;
    surface.origin = ray.origin;
    surface.geometric_normal = real3(real(0.0f), real(0.0f), real(1.0f));
    surface.normal = real3(real(0.6f), real(0.0f), real(0.8f));
    surface.material.diffuse = real3(real(0.5f), real(0.25f), real(1.0f));
    surface.material.specular = real3(real(0.0f));
    surface.material.emission = real3(real(0.0f));
    surface.material.mirror = false;
    return surface;
}
