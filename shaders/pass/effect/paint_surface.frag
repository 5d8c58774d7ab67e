#version 410 core
// Textures: the colour of each surface that is hit, from its picture where it has one.
#include <real>
#include "layout/far.glsl"
#include "layout/ray.glsl"
#include "layout/hit.glsl"
#include "layout/ray_texels.glsl"
#include "layout/hit_texel.glsl"
#include "layout/triangles.glsl"
#include "layout/surfaces.glsl"
#include "layout/pictures.glsl"
#include "geometry/vector.glsl"
#include "geometry/hit.glsl"
#include "geometry/leave_surface.glsl"
#include "shading/picture.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2D hits;
uniform float pixel_angle; // of a pixel in the picture's middle, in radians

out vec4 painted;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = unpack_hit(texelFetch(hits, pixel, 0));
    vec3 diffuse = triangle_material(hit.triangle).diffuse;
    int number = texelFetch(material_pictures, texelFetch(triangle_materials, hit.triangle).x).x;
    if (number != no_picture) {
        diffuse *= picture_at(ray, hit, picture_of(number), pixel_angle);
    }
    painted = vec4(diffuse, 0.0);
}
