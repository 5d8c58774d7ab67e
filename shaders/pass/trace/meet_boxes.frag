#version 410 core
// Which of a few boxes each ray meets: one bit a box.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "slab/boxes.glsl"
#include <slab>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int box_count; // 128 at most

layout(location = 0) out uvec4 met;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    SlabRay ray = prepare_slab_ray(
        unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0)));
    uvec4 bits = uvec4(0u);
    for (int i = 0; i < box_count; ++i) {
        bool meets = meets_slabs(ray, box_lower(i), box_upper(i));
        bits[i >> 5] |= meets ? 1u << uint(i & 31) : 0u;
    }
    met = bits;
}
