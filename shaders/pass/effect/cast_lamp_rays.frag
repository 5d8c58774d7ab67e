#version 410 core
// A shadow ray from each hit to a point of a lamp; an empty one where the lamp is behind.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/samples.glsl"
#include "light/surface.glsl"
#include "light/lambert.glsl"
#include "light/shadow.glsl"
#include <lamp>
#include <normal>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    Ray shadow = shadow_ray(with_normal(pixel, surface_at(ray, hit)), lamp_point(pixel));
    ray_origin = pack_ray_origin(shadow);
    ray_direction = pack_ray_direction(shadow);
}
