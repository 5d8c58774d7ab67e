#version 410 core
// A shadow ray from each hit to one light.
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "layout/surfaces.glsl"
#include "geometry/vector.glsl"
#include "geometry/hit.glsl"
#include "geometry/leave_surface.glsl"
#include "shading/surface.glsl"
#include "shading/lambert.glsl"
#include "shading/shadow.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D hits;
uniform vec3 light_position;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = unpack_hit(texelFetch(hits, pixel, 0));
    Ray shadow = shadow_ray(surface_at(ray, hit), light_position);
    ray_origin = pack_ray_origin(shadow);
    ray_direction = pack_ray_direction(shadow);
}
