#version 410 core
// The sky, where a path leaves the scene.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/vector.glsl"
#include "light/sky.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (is_hit(hit_at(hits, pixel))) {
        discard;
    }
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    precise vec3 weighted = vec3(texelFetch(weights, pixel, 0)) * sky_color(ray.direction);
    color = vec4(weighted, 0.0);
}
