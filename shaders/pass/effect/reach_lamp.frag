#version 410 core
// Where a shadow ray meets nothing more, its share of the lamp's light is what is left.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"

uniform usampler2DArray hits;
uniform sampler2D shares;

out vec4 share;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (is_hit(hit_at(hits, pixel))) {
        discard;
    }
    share = texelFetch(shares, pixel, 0);
}
