#version 410 core
// The second ray of each that met glass: the reflected one, which waits until the first has ended.
// Where the reflection is total there is none, since the first ray is it.
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "layout/surfaces.glsl"
#include "layout/glass.glsl"
#include "layout/media.glsl"
#include "geometry/vector.glsl"
#include "geometry/hit.glsl"
#include "geometry/leave_surface.glsl"
#include "shading/surface.glsl"
#include "shading/mirror.glsl"
#include "shading/fresnel.glsl"
#include "shading/glass.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D hits;
uniform sampler2D weights;
uniform usampler2D media;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight;
layout(location = 3) out uvec4 next_media;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = unpack_hit(texelFetch(hits, pixel, 0));
    if (!is_glass(hit.triangle)) {
        discard;
    }
    GlassMeeting meeting = meet_glass(ray, hit, surface_at(ray, hit), texelFetch(media, pixel, 0));
    bool total = meeting.reflected_part >= 1.0;
    ray_origin = pack_ray_origin(meeting.reflected);
    ray_direction = pack_ray_direction(meeting.reflected);
    precise vec3 kept = vec3(texelFetch(weights, pixel, 0)) *
                        glass_of(material_number(hit.triangle)).transparency *
                        (total ? 0.0 : meeting.reflected_part);
    weight = vec4(kept, 0.0);
    next_media = meeting.media_before;
}
