#version 410 core
// Vertex colours: those of the corners, interpolated, times the colour that the surface has anyway.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include <paint>

// Corner c of triangle i has its colour in texel 3i + c.
uniform samplerBuffer corner_colors;
uniform usampler2DArray hits;

out vec4 painted;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Hit hit = hit_at(hits, pixel);
    vec3 a = vec3(texelFetch(corner_colors, 3 * hit.triangle));
    vec3 b = vec3(texelFetch(corner_colors, 3 * hit.triangle + 1));
    vec3 c = vec3(texelFetch(corner_colors, 3 * hit.triangle + 2));
    vec3 tint = a + hit.u * (b - a) + hit.v * (c - a); // where all are white, white to the bit
    painted = vec4(painted_color(pixel, triangle_material(hit.triangle)) * tint, 0.0);
}
