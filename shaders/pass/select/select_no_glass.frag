#version 410 core
// Draws the pixels whose ray met something else than glass, or nothing.
#include <real>
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/hit_texel.glsl"
#include "layout/surfaces.glsl"
#include "layout/glass.glsl"
#include "geometry/hit.glsl"

uniform usampler2D hits;

void main() {
    Hit hit = unpack_hit(texelFetch(hits, ivec2(gl_FragCoord.xy), 0));
    if (is_hit(hit) && is_glass(hit.triangle)) {
        discard;
    }
}
