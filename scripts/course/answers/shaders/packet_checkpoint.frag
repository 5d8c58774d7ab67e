#version 410 core
// As checkpoint.frag, for exercises about the walks of packets.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/triangles.glsl"
#include "core/vector.glsl"
#include <triangle>
#include "cutout/none.glsl"
#include <observer>
#include <packet>
#include "probes.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int step_number;

uvec4 also = uvec4(0u);

#include <checkpoint>

layout(location = 0) out uvec4 answer;
layout(location = 1) out uvec4 more;
layout(location = 2) out uvec4 observed;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    answer = checkpoint(ray, step_number);
    more = also;
    observed = observations();
}
