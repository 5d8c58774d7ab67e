#version 410 core
// One ray, walked from its start in every pixel: so many rounds as the pixel's number says, or the
// same in all, for an observer that tells another event in each.
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
uniform ivec2 ray_pixel;
uniform float near_enough;
uniform int rounds; // negative: the number of the pixel

layout(location = 0) out uvec4 hit_texel;
layout(location = 1) out uvec4 place_texel;
layout(location = 2) out uvec4 observation_texel;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int own_rounds = rounds < 0 ? pixel.x + steps_in_row * pixel.y : rounds;
    Ray ray = unpack_ray(texelFetch(ray_origins, ray_pixel, 0), texelFetch(ray_directions, ray_pixel, 0));
    Walk walk = start_walk(ray);
    if (!walk.ended && own_rounds > 0) {
        walk = go_on(walk, ray, near_enough, own_rounds);
    }
    hit_texel = pack_hit(walk.nearest);
    place_texel = pack_place(walk);
    observation_texel = observations();
}
