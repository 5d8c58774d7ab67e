#version 410 core
// Each ray that met glass goes on behind the surface; or is reflected, where that is total.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "light/glass_materials.glsl"
#include "light/media.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/surface.glsl"
#include "light/mirror.glsl"
#include "light/fresnel.glsl"
#include "light/glass.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform usampler2D media;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight;
layout(location = 3) out uvec4 next_media;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    if (!is_glass(hit.triangle)) {
        discard;
    }
    GlassMeeting meeting = meet_glass(ray, hit, surface_at(ray, hit), texelFetch(media, pixel, 0));
    bool total = meeting.reflected_part >= 1.0;
    Ray next = meeting.refracted;
    if (total) {
        next = meeting.reflected;
    }
    ray_origin = pack_ray_origin(next);
    ray_direction = pack_ray_direction(next);
    precise vec3 kept = vec3(texelFetch(weights, pixel, 0)) *
                        glass_of(material_number(hit.triangle)).transparency *
                        (total ? 1.0 : 1.0 - meeting.reflected_part);
    weight = vec4(kept, 0.0);
    next_media = total ? meeting.media_before : meeting.media_behind;
}
