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

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int step_number;

#include <checkpoint>

out uvec4 answer;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    answer = checkpoint(ray, step_number);
}
