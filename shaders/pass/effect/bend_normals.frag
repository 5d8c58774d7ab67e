#version 410 core
// Normal maps: the normal of each surface that is hit, bent by its picture where it has one.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/surface.glsl"
#include "light/texture.glsl"
#include "light/normal_map.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform isamplerBuffer material_normals; // their pictures
uniform float pixel_angle;               // of a pixel in the picture's middle, in radians

out vec4 bent;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    Surface surface = surface_at(ray, hit);
    int number = texelFetch(material_normals, texelFetch(triangle_materials, hit.triangle).x).x;
    vec3 normal = surface.normal;
    if (number != no_picture) {
        normal = bent_normal(hit, surface, picture_at(ray, hit, picture_of(number), pixel_angle));
    }
    bent = vec4(normal, 0.0);
}
