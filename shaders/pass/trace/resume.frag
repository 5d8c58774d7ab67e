#version 410 core
// One launch of walks that take several. The first one starts those that have no hit yet; each
// other goes on where the last one stopped, with the hit that it had (the paper's `lasthit`).
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/walk.glsl"
#include "core/triangles.glsl"
#include "core/vector.glsl"
#include <triangle>
#include <cutout>
#include <observer>
#include <structure>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform bool first_launch;
uniform usampler2DArray last_hits;
uniform usampler2D last_places;
uniform usampler2D last_observations;
uniform float near_enough; // a hit at most this far ends the walk: see core/queries.glsl
uniform int rounds;        // what the platform's loops can bear in one launch

layout(location = 0) out uvec4 hit_texel;
layout(location = 1) out uvec4 place_texel;
layout(location = 2) out uvec4 observation_texel; // drawn only where an observer is at work

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    uvec4 last_hit = hit_texel_at(last_hits, pixel);
    Walk walk = start_walk(ray);
    if (first_launch) {
        if (!is_unfinished(last_hit)) {
            walk = ended_walk(last_hit);
        }
    } else {
        walk = unpack_walk(last_hit, texelFetch(last_places, pixel, 0));
        observe_from(texelFetch(last_observations, pixel, 0));
    }
    if (!walk.ended) {
        walk = go_on(walk, ray, near_enough, rounds);
    }
    hit_texel = pack_hit(walk.nearest);
    place_texel = pack_place(walk);
    observation_texel = observations();
}
