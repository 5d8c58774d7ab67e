#version 410 core
// The light of the rays that nothing stopped.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"

uniform usampler2DArray shadow_hits;
uniform sampler2D lights;

out vec4 color; // added to the samples

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (is_hit(hit_at(shadow_hits, pixel))) {
        discard;
    }
    color = texelFetch(lights, pixel, 0);
}
