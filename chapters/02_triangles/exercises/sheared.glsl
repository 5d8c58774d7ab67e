// A corner as the ray sees it, and the axis along which the ray is longest. The corner of step 1 is
// (0.25, 0.5, 0.75); of step 2 beside the origin, where the depth is zero; of step 3 close to the
// ray. Steps 4 to 6 ask these, and 7 to 9 as well, of a very small and a very large scene; steps 10
// and 11 the first and the second one with a very short direction.

uvec4 checkpoint(Ray ray, int step) {
    int kind = 1 + (step - 1) % 3;
    real scale = scale_of(1 + (step - 1) / 3);
    if (step >= 10) {
        scale = real(1.0f);
        ray.direction = ray.direction / real(1.2676506002282294e30f); // 2^100
    }
    PreparedRay prepared = prepare_ray(ray);
    real3 corner = real3(real(0.25f), real(0.5f), real(0.75f));
    if (kind == 2) {
        corner = ray.origin;
        corner[(prepared.axis + 1) % 3] = corner[(prepared.axis + 1) % 3] + real(1.0f);
    }
    if (kind == 3) {
        corner = ray.origin + real(0.5f) * ray.direction;
    }
    ray.origin = scale * ray.origin;
    prepared.origin = ray.origin;
    real3 seen = sheared(prepared, scale * corner);
    seen = seen / scale;
    seen.z = step == 10 ? seen.z / real(1.2676506002282294e30f) : seen.z;
    return bits_of_point(seen, prepared.axis);
}
