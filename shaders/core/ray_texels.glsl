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
