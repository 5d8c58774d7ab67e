#version 410 core
// Primary rays as the paper makes them: each pixel finds its direction ready, interpolated.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/view.glsl"

uniform View view;

in vec3 corner_direction;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    Ray ray;
    ray.origin = view.eye;
    ray.direction = corner_direction;
    ray.t_min = 0.0;
    ray.t_max = farthest;
    ray_origin = pack_ray_origin(ray);
    ray_direction = pack_ray_direction(ray);
}
