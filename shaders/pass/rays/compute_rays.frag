#version 410 core
// Primary rays computed by each pixel from its own place.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/view.glsl"

uniform View view;
uniform vec2 picture_size; // in pixels

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;

void main() {
    //# exercise 1.2: the place of a pixel in the picture
    // gl_FragCoord is the centre of the pixel: (0.5, 0.5) in the lower left one.
    Ray ray = primary_ray(view, gl_FragCoord.x / picture_size.x, gl_FragCoord.y / picture_size.y);
    //# stub: Ray ray = primary_ray(view, 0.5, 0.5);
    //# end
    ray_origin = pack_ray_origin(ray);
    ray_direction = pack_ray_direction(ray);
}
