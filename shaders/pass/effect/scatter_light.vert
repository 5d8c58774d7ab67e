#version 410 core
// Each ray of a list carries its light to its own pixel: a point there, one pixel large.

uniform sampler2D lights;       // of the rays, row by row
uniform isamplerBuffer targets; // the pixel of each ray, its row times the width plus its column
uniform int picture_width;
uniform int picture_height;

flat out vec3 light;

void main() {
    int row_length = textureSize(lights, 0).x;
    light = vec3(texelFetch(lights, ivec2(gl_VertexID % row_length, gl_VertexID / row_length), 0));
    int target = texelFetch(targets, gl_VertexID).x;
    vec2 pixel = vec2(target % picture_width, target / picture_width);
    gl_Position = vec4(2.0 * (pixel + 0.5) / vec2(picture_width, picture_height) - 1.0, 0.0, 1.0);
}
