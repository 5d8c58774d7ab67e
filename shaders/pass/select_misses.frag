#version 410 core
// Draws the pixels whose ray left the scene.
#include "geometry/hit.glsl"
#include "layout/hit.glsl"
#include "layout/hit_texel.glsl"
#include "layout/ray.glsl"
#include <real>

uniform usampler2D hits;

void main() {
    if (is_hit(unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0)))) {
        discard;
    }
}
