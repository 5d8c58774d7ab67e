#version 410 core
// The diffuse light of a lamp on each hit.
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
#include <lamp>
#include <normal>
#include <paint>
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
    Surface surface = with_normal(pixel, surface_at(ray, hit));
    vec3 lamp = lamp_point(pixel);
    vec3 share = light_share(pixel);
    color = vec4(0.0);
    if (share != vec3(0.0) && faces_light(surface, lamp)) {
        surface.material.diffuse = painted_color(pixel, surface.material);
        precise vec3 weighted =
            vec3(texelFetch(weights, pixel, 0)) * diffuse_light(surface, lamp, light_color) * share;
        color = vec4(weighted, 0.0);
    }
}
