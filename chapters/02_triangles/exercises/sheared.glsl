// The corner (0.25, 0.5, 0.75) as the ray sees it, and the axis along which the ray is longest.

uvec4 checkpoint(Ray ray, int step) {
    PreparedRay prepared = prepare_ray(ray);
    real3 corner = sheared(prepared, real3(real(0.25f), real(0.5f), real(0.75f)));
    return bits_of_point(corner, prepared.axis);
}
