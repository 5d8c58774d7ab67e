#version 410 core
// Textures: the colour of each surface that is hit, from its picture where it has one.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include "light/texture.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform float pixel_angle; // of a pixel in the picture's middle, in radians

out vec4 painted;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    vec3 diffuse = triangle_material(hit.triangle).diffuse;
    int number = texelFetch(material_pictures, texelFetch(triangle_materials, hit.triangle).x).x;
    if (number != no_picture) {
        diffuse *= picture_at(ray, hit, picture_of(number), pixel_angle);
    }
    painted = vec4(diffuse, 0.0);
}
