#version 410 core
// Emissive pictures: what each surface that is hit shines with of its own, where it has a picture
// of that. Other surfaces get no light from it.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/texture.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;
uniform isamplerBuffer material_glows; // their pictures
uniform samplerBuffer glow_factors;    // of the materials: what the pictures are multiplied by
uniform float pixel_angle;             // of a pixel in the picture's middle, in radians

out vec4 color; // added to the picture

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Hit hit = hit_at(hits, pixel);
    int material = texelFetch(triangle_materials, hit.triangle).x;
    int number = texelFetch(material_glows, material).x;
    if (number == no_picture) {
        discard;
    }
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    precise vec3 weighted = vec3(texelFetch(weights, pixel, 0)) *
                            vec3(texelFetch(glow_factors, material)) *
                            picture_at(ray, hit, picture_of(number), pixel_angle);
    color = vec4(weighted, 0.0);
}
