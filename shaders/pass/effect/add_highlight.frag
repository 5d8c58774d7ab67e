#version 410 core
// The glossy highlight of a lamp on each hit whose material has one.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/samples.glsl"
#include "light/surface.glsl"
#include "light/lambert.glsl"
#include "light/highlight.glsl"
#include <lamp>
#include <normal>
#include <visibility>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform vec3 light_color;

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    Gloss gloss = gloss_of(texelFetch(triangle_materials, hit.triangle).x);
    if (gloss.exponent == 0.0) {
        discard;
    }
    Surface surface = with_normal(pixel, surface_at(ray, hit));
    vec3 lamp = lamp_point(pixel);
    vec3 share = light_share(pixel);
    color = vec4(0.0);
    if (share != vec3(0.0) && faces_light(surface, lamp)) {
        precise vec3 weighted = vec3(texelFetch(weights, pixel, 0)) *
                                highlight(surface, ray.direction, lamp, light_color, gloss) * share;
        color = vec4(weighted, 0.0);
    }
}
