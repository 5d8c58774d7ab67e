#version 410 core
// The light of one lamp on each hit, where its shadow ray met nothing.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/surface.glsl"
#include "light/lambert.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform usampler2DArray shadow_hits;
uniform sampler2D weights;
uniform vec3 light_position;
uniform vec3 light_color;

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Surface surface = surface_at(ray, hit_at(hits, pixel));
    bool blocked = is_hit(hit_at(shadow_hits, pixel));
    color = vec4(0.0);
    if (!blocked && faces_light(surface, light_position)) {
        precise vec3 weighted = vec3(texelFetch(weights, pixel, 0)) *
                                diffuse_light(surface, light_position, light_color);
        color = vec4(weighted, 0.0);
    }
}
