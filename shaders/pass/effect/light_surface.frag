#version 410 core
// The diffuse light of a lamp on each hit.
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "layout/surfaces.glsl"
#include "geometry/vector.glsl"
#include "geometry/hit.glsl"
#include "geometry/leave_surface.glsl"
#include "geometry/samples.glsl"
#include "shading/surface.glsl"
#include "shading/lambert.glsl"
#include <lamp>
#include <paint>
#include <visibility>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D hits;
uniform sampler2D weights;
uniform vec3 light_color;

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = unpack_hit(texelFetch(hits, pixel, 0));
    Surface surface = surface_at(ray, hit);
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
