#version 410 core
// Draws the pixels whose ray left the scene.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"

uniform usampler2D hits;

void main() {
    if (is_hit(unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0)))) {
        discard;
    }
}
