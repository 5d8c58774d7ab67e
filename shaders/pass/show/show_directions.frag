#version 410 core
// The directions of rays as colours.
#include "light/color_of_direction.glsl"

uniform sampler2D ray_directions;

out vec4 color;

void main() {
    vec3 direction = vec3(texelFetch(ray_directions, ivec2(gl_FragCoord.xy), 0));
    color = vec4(color_of_direction(normalize(direction)), 1.0);
}
