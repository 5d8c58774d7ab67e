#version 410 core
// One launch of a walk: each ray goes on from its last hit (the paper's `lasthit`).
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "geometry/vector.glsl"
#include "geometry/ray.glsl"
#include "geometry/hit.glsl"
#include <triangle>
#include <observer>
#include <structure>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D last_hits;
uniform float near_enough; // a hit at most this far ends the walk: see geometry/queries.glsl

out uvec4 hit_texel;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit best = unpack_hit(texelFetch(last_hits, pixel, 0));
    bool has_answer = is_hit(best) && best.t <= near_enough;
    if (has_answer || is_empty(ray)) {
        hit_texel = pack_hit(best);
        return;
    }
    // What lies behind the best hit so far cannot win any more.
    ray.t_max = best.t;
    Hit hit = find_hit(ray, near_enough);
    hit_texel = pack_hit(hit.triangle == unfinished_walk || is_nearer(hit, best) ? hit : best);
}
