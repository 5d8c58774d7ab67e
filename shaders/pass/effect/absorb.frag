#version 410 core
// Absorption: a path that came through an absorbing body to its hit counts less from there on.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "light/glass_materials.glsl"
#include "light/media.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/absorption.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform usampler2D media;

out vec4 weight;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    vec4 before = texelFetch(weights, pixel, 0);
    vec3 kept = vec3(before);
    int material = innermost_medium(texelFetch(media, pixel, 0));
    if (is_hit(hit) && material >= 0) {
        kept *= transmitted(glass_of(material).transmission, travelled(ray, hit));
    }
    weight = vec4(kept, before.w);
}
