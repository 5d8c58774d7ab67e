#version 410 core
// Anti-aliasing: each sample of a pixel has its ray through another place of it.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/view.glsl"
#include "light/samples.glsl"

uniform View view;
uniform vec2 picture_size; // in pixels
uniform int pixel_sample;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    SquarePoint place = point_in_pixel(pixel_sample);
    // gl_FragCoord is the centre of the pixel.
    Ray ray = primary_ray(view, (gl_FragCoord.x + (place.x - 0.5)) / picture_size.x,
                          (gl_FragCoord.y + (place.y - 0.5)) / picture_size.y);
    ray_origin = pack_ray_origin(ray);
    ray_direction = pack_ray_direction(ray);
}
