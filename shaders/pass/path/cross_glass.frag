#version 410 core
// Each path that meets glass goes through or is reflected, as likely as light does.
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
#include "light/glass_materials.glsl"
#include "light/media.glsl"
#include "light/mirror.glsl"
#include "light/fresnel.glsl"
#include "light/glass.glsl"
#include "light/hash.glsl"
#include <random>
#include <roulette>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform usampler2D media;
uniform int bounce; // 0 where the camera looks

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight;
layout(location = 3) out uvec4 next_media;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    PathSample path = sample_at(pixel.x, pixel.y);
    int pairs = pairs_of_bounce * bounce;
    SquarePoint choices = random_point(path.pixel, path.sample_number, pairs + pair_of_choices);
    float share = matte_share(hit.triangle);
    if (choices.x < share || !is_glass(hit.triangle)) {
        discard;
    }
    GlassMeeting meeting = meet_glass(ray, hit, surface_at(ray, hit), texelFetch(media, pixel, 0));
    float lot = random_point(path.pixel, path.sample_number, pairs + pair_of_direction).x;
    PathStep onward;
    onward.ray = meeting.refracted;
    next_media = meeting.media_behind;
    if (lot < meeting.reflected_part) {
        onward.ray = meeting.reflected;
        next_media = meeting.media_before;
    }
    onward.weight = vec3(texelFetch(weights, pixel, 0)) *
                    glass_of(material_number(hit.triangle)).transparency / (1.0 - share);
    onward.density = 0.0;
    onward = after_roulette(onward, chance_to_go_on(onward.weight, bounce), choices.y);
    ray_origin = pack_ray_origin(onward.ray);
    ray_direction = pack_ray_direction(onward.ray);
    weight = vec4(onward.weight, onward.density);
}
