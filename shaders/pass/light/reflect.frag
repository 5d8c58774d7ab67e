#version 410 core
// Each ray that hit a mirror goes on from there, and its colour counts as much less as the mirror
// keeps.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/surface.glsl"
#include "light/mirror.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Surface surface = surface_at(ray, hit_at(hits, pixel));
    Ray reflected = mirror_ray(surface, ray);
    ray_origin = pack_ray_origin(reflected);
    ray_direction = pack_ray_direction(reflected);
    precise vec3 kept = vec3(texelFetch(weights, pixel, 0)) * surface.material.specular;
    weight = vec4(kept, 0.0);
}
