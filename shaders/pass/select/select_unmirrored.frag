#version 410 core
// Draws the pixels whose path ends at a surface that is no mirror.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "light/materials.glsl"

uniform usampler2D hits;

void main() {
    Hit hit = unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0));
    if (triangle_material(hit.triangle).mirror) {
        discard;
    }
}
