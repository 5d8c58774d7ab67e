#version 410 core
// Draws the pixels whose ray met glass.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "light/materials.glsl"
#include "light/glass_materials.glsl"

uniform usampler2D hits;

void main() {
    Hit hit = unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0));
    if (!is_hit(hit) || !is_glass(hit.triangle)) {
        discard;
    }
}
