#version 410 core
// What a path sees without any light: the background where it leaves the scene, and the glow of
// what it hits.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "light/materials.glsl"

uniform usampler2DArray hits;
uniform sampler2D weights;
uniform vec3 background;

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Hit hit = hit_at(hits, pixel);
    vec3 seen = background;
    if (is_hit(hit)) {
        seen = triangle_material(hit.triangle).emission;
    }
    precise vec3 weighted = vec3(texelFetch(weights, pixel, 0)) * seen;
    color = vec4(weighted, 0.0);
}
