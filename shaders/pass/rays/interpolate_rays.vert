#version 410 core
// The four corners of the picture carry the four corner rays; the rasterizer interpolates between
// them. Source: Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing",
// 2010, section 2.2.
#include <real>
#include "core/ray.glsl"
#include "core/view.glsl"

uniform View view;

out vec3 corner_direction;

void main() {
    float s = float(gl_VertexID & 1);
    float t = float(gl_VertexID >> 1);
    //# exercise 1.3: the ray of a corner
    corner_direction = view.lower_left + s * view.right + t * view.up;
    //# stub: corner_direction = view.lower_left;
    //# end
    gl_Position = vec4(2.0 * s - 1.0, 2.0 * t - 1.0, 0.0, 1.0);
}
