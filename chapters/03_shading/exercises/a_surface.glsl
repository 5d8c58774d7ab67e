// A surface at the ray's origin. Its plane looks up along z and its normal leans to x; as the other
// one, its plane leans and its normal looks along y.

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

Surface other_surface_of(Ray ray) {
    Surface surface = surface_of(ray);
    surface.geometric_normal = real3(real(0.48f), real(0.64f), real(0.6f));
    surface.normal = real3(real(0.0f), real(1.0f), real(0.0f));
    surface.material.diffuse = real3(real(0.75f), real(0.875f), real(0.125f));
    surface.material.specular = real3(real(0.5f), real(0.25f), real(0.75f));
    surface.material.emission = real3(real(0.25f), real(0.5f), real(0.125f));
    surface.material.mirror = true;
    return surface;
}
