#version 410 core
// What glows where a path arrives by chance: its share beside the rays that are sent to lamps.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/samples.glsl"
#include "light/path.glsl"
#include <heuristic>
#include "light/emitters.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform usampler2DArray hits;
uniform sampler2D weights;

out vec4 color; // added to the samples

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    Hit hit = hit_at(hits, pixel);
    if (!is_hit(hit)) {
        discard;
    }
    vec3 emission = triangle_material(hit.triangle).emission;
    vec3 normal = front_normal(hit.triangle);
    if (emission == vec3(0.0) || dot_product(normal, ray.direction) >= 0.0) {
        discard;
    }
    vec4 weight = texelFetch(weights, pixel, 0); // in w the density of the ray's direction
    float there = density_over_angles(density_of_emission(emission), hit.t * ray.direction, normal);
    float share = share_of_glow(weight.w, there);
    color = vec4(vec3(weight) * emission * share, 0.0);
}
