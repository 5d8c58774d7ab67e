#version 410 core
// Draws the pixels whose path ends at a surface that is no mirror.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "light/materials.glsl"

uniform usampler2DArray hits;

void main() {
    Hit hit = hit_at(hits, ivec2(gl_FragCoord.xy));
    if (triangle_material(hit.triangle).mirror) {
        discard;
    }
}
