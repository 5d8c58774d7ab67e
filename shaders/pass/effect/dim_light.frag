#version 410 core
// A shadow ray that met glass goes straight on behind it, with less light. Where it leaves the
// glass it has come through, what that absorbs is lost too.
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
#include "light/absorption.glsl"
#include "light/glass.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D shares;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 share;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    if (!is_hit(hit) || !is_glass(hit.triangle)) {
        discard;
    }
    Surface surface = surface_at(ray, hit);
    Glass glass = glass_of(material_number(hit.triangle));
    bool outside = meets_outside(ray, hit);
    real cosine =
        clamp(-dot_product(unit(ray.direction), surface.geometric_normal), real(0.0), real(1.0));
    // As if each body stood in air: by the same angle the light comes in and goes out.
    vec3 kept = vec3(texelFetch(shares, pixel, 0)) * glass.transparency *
                (1.0 - reflected_part(cosine, 1.0, glass.index));
    if (!outside) {
        kept *= transmitted(glass.transmission, travelled(ray, hit));
    }
    share = vec4(kept, 0.0);
    Ray rest = ray;
    rest.origin = origin_behind(surface, hit);
    precise vec3 way = ray.origin + ray.direction - rest.origin; // t = 1 was the lamp
    rest.direction = way;
    ray_origin = pack_ray_origin(rest);
    ray_direction = pack_ray_direction(rest);
}
