#version 410 core
// Draws the pixels that have a ray to trace.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (is_empty(
            unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0)))) {
        discard;
    }
}
