#version 410 core
// From each matte surface a ray to a point of what glows, and the light that comes along it where
// nothing stands between.
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
#include "light/hash.glsl"
#include "light/lambert.glsl"
#include "light/shadow.glsl"
#include <random>
#include <bounce>
#include <heuristic>
#include "light/emitters.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform int bounce; // 0 where the camera looks

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    PathSample path = sample_at(pixel.x, pixel.y);
    Surface surface = surface_at(ray, hit);
    LampPoint lamp = point_of_emitters(
        random_point(path.pixel, path.sample_number, pairs_of_bounce * bounce + pair_of_lamp));
    vec3 way = lamp.point - surface.origin;
    Ray to_lamp = shadow_ray(surface, lamp.point);
    light = vec4(0.0);
    if (is_empty(to_lamp) || dot_product(lamp.normal, way) >= 0.0 ||
        surface.material.diffuse == vec3(0.0)) {
        to_lamp.t_max = -1.0;
    } else {
        float cosine = dot_product(surface.normal, unit(way));
        float there = density_over_angles(density_of_emission(lamp.emission), way, lamp.normal);
        float share = share_of_light(there, matte_share(hit.triangle) * bounce_density(cosine));
        light = vec4(vec3(texelFetch(weights, pixel, 0)) * surface.material.diffuse *
                         (cosine / pi) * lamp.emission / there * share,
                     0.0);
    }
    ray_origin = pack_ray_origin(to_lamp);
    ray_direction = pack_ray_direction(to_lamp);
}
