#version 410 core
// Draws the pixels whose ray left the scene.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"

uniform usampler2DArray hits;

void main() {
    if (is_hit(hit_at(hits, ivec2(gl_FragCoord.xy)))) {
        discard;
    }
}
