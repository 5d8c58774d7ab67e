#version 410 core
// The initialising kernel: before the first launch of a walk, each ray has hit nothing.
#include <real>
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "geometry/hit.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;

out uvec4 hit_texel;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    hit_texel = pack_hit(
        miss(unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0))));
}
