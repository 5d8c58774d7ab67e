#version 410 core
// Depth of field: the pinhole's rays start on a lens instead.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/view.glsl"
#include "core/vector.glsl"
#include "light/samples.glsl"
#include "light/lens.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform View view;
uniform float lens_radius;
uniform float focus_distance;
uniform int lens_sample;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    SquarePoint place = point_of_disc(point_for_lens(lens_sample, pixel.x, pixel.y));
    Ray moved = lens_ray(ray, view, lens_radius, focus_distance, place);
    ray_origin = pack_ray_origin(moved);
    ray_direction = pack_ray_direction(moved);
}
