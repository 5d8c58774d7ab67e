#version 410 core
// Draws the pixels whose walk was cut short, so that a query can count them.
#include <real>
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/hit_texel.glsl"

uniform usampler2D hits;

void main() {
    Hit hit = unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0));
    if (hit.triangle != unfinished_walk) {
        discard;
    }
}
