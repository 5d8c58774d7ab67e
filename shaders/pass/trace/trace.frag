#version 410 core
// The walks of all rays, each to its end where the platform's loops can bear it. One that is longer
// leaves no mark: pass/trace/resume.frag walks it in several launches.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/walk.glsl"
#include "core/triangles.glsl"
#include "core/vector.glsl"
#include <triangle>
#include <cutout>
#include "observer/none.glsl"
#include <structure>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform float near_enough; // a hit at most this far ends the walk: see core/queries.glsl
uniform int rounds;        // what the platform's loops can bear in one launch

out uvec4 hit_texel;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Walk walk = start_walk(ray);
    if (!walk.ended) {
        walk = go_on(walk, ray, near_enough, rounds);
    }
    if (!walk.ended) {
        discard;
    }
    hit_texel = pack_hit(walk.nearest);
}
