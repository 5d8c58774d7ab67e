// How a ray lies in two RGBA float texels: origin and t_min, direction and t_max.

Ray unpack_ray(vec4 origin_texel, vec4 direction_texel) {
    Ray ray;
    ray.origin = real3(origin_texel);
    ray.t_min = real(origin_texel.w);
    ray.direction = real3(direction_texel);
    ray.t_max = real(direction_texel.w);
    return ray;
}

vec4 pack_ray_origin(Ray ray) {
    return vec4(vec3(ray.origin), float(ray.t_min));
}

vec4 pack_ray_direction(Ray ray) {
    return vec4(vec3(ray.direction), float(ray.t_max));
}

// How a hit lies in one RGBA texel, as the paper wants it: t, u, v and the triangle. The texel
// holds the bits of the numbers as integers, so that the triangle is exact beyond 2^24 and nothing
// is flushed to zero on the way.

uvec4 pack_hit(Hit hit) {
    return uvec4(floatBitsToUint(float(hit.t)), floatBitsToUint(float(hit.u)),
                 floatBitsToUint(float(hit.v)), uint(hit.triangle));
}

Hit unpack_hit(uvec4 texel) {
    Hit hit;
    hit.t = real(uintBitsToFloat(texel.x));
    hit.u = real(uintBitsToFloat(texel.y));
    hit.v = real(uintBitsToFloat(texel.z));
    hit.triangle = int(texel.w);
    return hit;
}
