#version 410 core
// Draws the pixels whose ray left the scene.
#include <real>
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/hit_texel.glsl"
#include "geometry/hit.glsl"

uniform usampler2D hits;

void main() {
    if (is_hit(unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0)))) {
        discard;
    }
}
