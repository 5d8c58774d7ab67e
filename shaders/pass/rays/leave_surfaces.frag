#version 410 core
// A ray that leaves each hit in a direction given: how it gets off the surface is a part.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "offset/surface_point.glsl"
#include "core/vector.glsl"
#include <offset>

uniform usampler2DArray hits;
uniform sampler2D leaving_directions; // with a positive share along the normal of the triangle

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Hit hit = hit_at(hits, pixel);
    SurfacePoint from;
    from.a = triangle_corner(hit.triangle, 0);
    from.b = triangle_corner(hit.triangle, 1);
    from.c = triangle_corner(hit.triangle, 2);
    precise real3 point = from.a + hit.u * (from.b - from.a) + hit.v * (from.c - from.a);
    from.point = point;
    real3 leaving = real3(texelFetch(leaving_directions, pixel, 0));
    real3 upright = cross_product(from.b - from.a, from.c - from.a);
    from.normal = unit(is_zero(upright) ? leaving : upright);

    Ray ray;
    ray.origin = leaving_point(from);
    ray.direction = leaving;
    ray.t_min = real(leaving_t_min);
    ray.t_max = hit.triangle >= 0 ? real(farthest) : -real(1.0f);
    ray_origin = pack_ray_origin(ray);
    ray_direction = pack_ray_direction(ray);
}
