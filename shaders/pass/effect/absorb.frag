#version 410 core
// Absorption: a path that came through an absorbing body to its hit counts less from there on.
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "layout/surfaces.glsl"
#include "layout/glass.glsl"
#include "layout/media.glsl"
#include "geometry/vector.glsl"
#include "geometry/hit.glsl"
#include "geometry/leave_surface.glsl"
#include "shading/absorption.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D hits;
uniform sampler2D weights;
uniform usampler2D media;

out vec4 weight;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = unpack_hit(texelFetch(hits, pixel, 0));
    vec3 kept = vec3(texelFetch(weights, pixel, 0));
    int material = innermost_medium(texelFetch(media, pixel, 0));
    if (is_hit(hit) && material >= 0) {
        kept *= transmitted(glass_of(material).transmission, travelled(ray, hit));
    }
    weight = vec4(kept, 0.0);
}
