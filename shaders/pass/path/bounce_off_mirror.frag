#version 410 core
// Each path that a surface sends on as a mirror.
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
#include "light/path.glsl"
#include "light/mirror.glsl"
#include "light/hash.glsl"
#include <random>
#include <roulette>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform int bounce; // 0 where the camera looks

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    PathSample path = sample_at(pixel.x, pixel.y);
    SquarePoint choices =
        random_point(path.pixel, path.sample_number, pairs_of_bounce * bounce + pair_of_choices);
    float share = matte_share(hit.triangle);
    if (choices.x < share) {
        discard;
    }
    Surface surface = surface_at(ray, hit);
    PathStep onward;
    onward.ray = mirror_ray(surface, ray);
    onward.weight = vec3(texelFetch(weights, pixel, 0)) * surface.material.specular / (1.0 - share);
    onward.density = 0.0;
    onward = after_roulette(onward, chance_to_go_on(onward.weight, bounce), choices.y);
    ray_origin = pack_ray_origin(onward.ray);
    ray_direction = pack_ray_direction(onward.ray);
    weight = vec4(onward.weight, onward.density);
}
