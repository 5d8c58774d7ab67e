#version 410 core
// Draws the pixels whose ray met something else than glass, or nothing.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "light/materials.glsl"
#include "light/glass_materials.glsl"

uniform usampler2DArray hits;

void main() {
    Hit hit = hit_at(hits, ivec2(gl_FragCoord.xy));
    if (is_hit(hit) && is_glass(hit.triangle)) {
        discard;
    }
}
